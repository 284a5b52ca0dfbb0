#include "app/push/drawn_picture.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_view.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

namespace app {
namespace {

constexpr double kPageMargin = 24.0, kPageTitle = 58.0;  // of the page [px]
constexpr double kPanelWide = 330.0, kPanelHigh = 330.0; // of a wall, at most [px]
constexpr double kPanelHead = 26.0, kColourRoom = 46.0, kPanelGap = 30.0; // of a panel [px]
constexpr std::size_t kPanelColumns = 3;

struct ValueColour {
    double red, green, blue; ///< 0 to 255
};
/// From small to large; all of them are seen on white, and apart in grey.
constexpr std::array kValueColours = {ValueColour{13, 8, 135}, ValueColour{126, 3, 168},
                                      ValueColour{204, 71, 120}, ValueColour{248, 149, 64}};

/// @param share 0 to 1
std::string value_colour(double share)
{
    const double at = share * (kValueColours.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), kValueColours.size() - 2);
    const ValueColour &a = kValueColours[i], &b = kValueColours[i + 1];
    const auto between = [&](double x, double y) {
        return static_cast<unsigned>(std::lround(x + (at - static_cast<double>(i)) * (y - x)));
    };
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", between(a.red, b.red),
                  between(a.green, b.green), between(a.blue, b.blue));
    return text.data();
}

std::string draw_outlines(const dem::Layout& layout, const WallView& view)
{
    std::string drawn;
    for (int b = 0; b < layout.beam; ++b) {
        std::vector<Pixel> corners;
        for (const dem::Point& p : dem::corners_of(layout.blocks[static_cast<std::size_t>(b)]))
            corners.push_back(view.place(p));
        drawn += svg_polygon(corners, "");
    }
    return svg_group("fill=\"#fafafa\" stroke=\"#ccc\" stroke-width=\"0.7\"", drawn);
}

std::string draw_values(const dem::Layout& layout, const WallView& view, Varies varies,
                        std::span<const double> values, double least, double most)
{
    std::string drawn;
    for (const dem::Face& f : layout.faces) {
        if (f.id == 0 || (f.kind == dem::FaceKind::unit_crack) != (varies == Varies::by_crack))
            continue;
        const double value = values[static_cast<std::size_t>(f.id - 1)];
        const double share = most > least ? (value - least) / (most - least) : 0.5;
        drawn += svg_line(view.place(f.from), view.place(f.to),
                          svg_attribute("stroke", value_colour(share)));
    }
    return svg_group("stroke-width=\"4\"", drawn);
}

/// The colours from the smallest to the largest value, with both and the mean in words.
std::string draw_scale(Pixel at, double width, const RandomInput& input, double least,
                       double mean, double most)
{
    constexpr int kSteps = 40;
    constexpr double kHeight = 10.0;
    std::string bar;
    for (int i = 0; i < kSteps; ++i)
        bar += svg_rectangle({at.x + width * i / kSteps, at.y}, width / kSteps + 0.3, kHeight,
                             svg_attribute("fill", value_colour((i + 0.5) / kSteps)));
    const auto shown = [&](double value) { return number(from_si(value, input.unit), 3); };
    const double y = at.y + kHeight + 15.0;
    const std::string small = "font-size=\"12\" ";
    return bar + svg_text({at.x, y}, shown(least), small) +
           svg_text({at.x + 0.5 * width, y}, "mean " + shown(mean),
                    small + svg_attribute("text-anchor", "middle")) +
           svg_text({at.x + width, y}, shown(most),
                    small + svg_attribute("text-anchor", "end"));
}

} // namespace

std::string drawn_picture(const std::vector<RandomInput>& random, const dem::Layout& layout,
                          const WallDraw& draw)
{
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < draw.values.size(); ++i)
        if (draw.values[i].size() > 1) shown.push_back(i);
    if (shown.empty()) return {};
    double low = layout.blocks.front().x0, high = layout.blocks.front().x1;
    for (int b = 0; b < layout.beam; ++b) {
        low = std::min(low, layout.blocks[static_cast<std::size_t>(b)].x0);
        high = std::max(high, layout.blocks[static_cast<std::size_t>(b)].x1);
    }
    const double scale = std::min(kPanelWide / (high - low), kPanelHigh / layout.height);
    const double width = scale * (high - low), height = scale * layout.height;
    const double panel_width = std::max(width, 230.0) + kPanelGap; // room for the name
    const double panel_height = kPanelHead + height + kColourRoom + kPanelGap;
    std::string body =
        svg_text({kPageMargin, 26.0}, "Values drawn for each joint and crack",
                 "font-size=\"17\" font-weight=\"bold\"") +
        svg_text({kPageMargin, 46.0}, "each from the smallest to the largest of this wall",
                 "font-size=\"12\"");
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const RandomInput& input = random[shown[k]];
        const std::vector<double>& values = draw.values[shown[k]];
        const auto [least, most] = std::ranges::minmax(values);
        double mean = 0.0;
        for (const double v : values) mean += v / static_cast<double>(values.size());
        const Pixel corner = {
            kPageMargin + panel_width * static_cast<double>(k % kPanelColumns),
            kPageTitle + panel_height * static_cast<double>(k / kPanelColumns)};
        const WallView view{.pixels_per_metre = scale,
                            .origin = {corner.x - scale * low, corner.y + kPanelHead + height}};
        const std::string unit = input.unit.empty() ? "-" : std::string(input.unit);
        body += svg_text({corner.x, corner.y + 16.0}, input.key + " [" + unit + "]",
                         "font-size=\"13\" font-weight=\"bold\"") +
                draw_outlines(layout, view) +
                draw_values(layout, view, input.varies, values, least, most) +
                draw_scale({corner.x, corner.y + kPanelHead + height + 12.0}, width, input,
                           least, mean, most);
    }
    const std::size_t columns = std::min(kPanelColumns, shown.size());
    const std::size_t rows = (shown.size() + kPanelColumns - 1) / kPanelColumns;
    return svg_page(2.0 * kPageMargin + panel_width * static_cast<double>(columns) - kPanelGap,
                    kPageTitle + panel_height * static_cast<double>(rows),
                    "Values drawn for each joint and crack", body);
}

} // namespace app
