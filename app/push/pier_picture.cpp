#include "app/push/pier_picture.hpp"

#include "app/input/study/load_input.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/output/picture/svg_elements.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/stored/stress_text.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace app {
namespace {

constexpr double kMargin = 24.0, kHead = 62.0; // [px]

/// Places of the wall on the page.
struct Places {
    dem::Region wall;
    double scale = 1.0; ///< [px/m]

    [[nodiscard]] Pixel operator()(dem::Point p) const
    {
        return {kMargin + scale * (p.x - wall.x0), kHead + scale * (wall.z1 - p.z)};
    }
};

/// A line around what is filled.
std::string edge(std::string_view colour, double width)
{
    return svg_attribute("stroke", colour) + svg_attribute("stroke-width", svg_number(width));
}

std::string halo() { return svg_attribute("paint-order", "stroke") + edge("#fff", 3.0); }

std::string draw_stones(const dem::Layout& layout, const Places& place)
{
    std::string drawn;
    for (int b = 0; b < layout.beam; ++b) {
        std::vector<Pixel> corners;
        for (const dem::Point& p : dem::corners_of(layout.blocks[static_cast<std::size_t>(b)]))
            corners.push_back(place(p));
        drawn += svg_polygon(corners, "");
    }
    return svg_group(svg_attribute("fill", "#f6f0e4") + edge("#c9bda3", 0.7), drawn);
}

std::string draw_pier(const PierReading& p, std::size_t number, const Places& place)
{
    const Pixel corner = place({p.pier.at.x0, p.pier.at.z1}),
                far = place({p.pier.at.x1, p.pier.at.z0});
    std::string drawn =
        svg_rectangle(corner, far.x - corner.x, far.y - corner.y,
                      svg_attribute("fill", "#0072B2") + svg_attribute("fill-opacity", "0.16") +
                          edge("#0072B2", 1.6));
    const std::array<std::string, 5> lines = {
        "pier " + std::to_string(number),
        "N " + fixed(p.facts.normal_at_peak * 1e-3, 1) + " kN",
        "V " + fixed(p.facts.shear_at_peak * 1e-3, 1) + " kN", fixed(100.0 * p.drift, 2) + " %",
        std::string(mode_text(p))};
    constexpr double kLine = 15.0;
    double y = 0.5 * (corner.y + far.y) - 0.5 * kLine * static_cast<double>(lines.size() - 1);
    for (const std::string& line : lines) {
        drawn += svg_text({0.5 * (corner.x + far.x), y}, line,
                          halo() + svg_attribute("text-anchor", "middle") +
                              svg_attribute("font-size", "12") +
                              (&line == lines.data() ? "font-weight=\"bold\"" : ""));
        y += kLine;
    }
    return drawn;
}

std::string draw_spandrel(const SpandrelReading& s, const Places& place)
{
    const dem::Region& at = s.spandrel.at;
    const Pixel middle = place({0.5 * (at.x0 + at.x1), 0.5 * (at.z0 + at.z1)});
    return svg_text({middle.x, middle.y + 4.0},
                    "V " + fixed(s.facts.shear_at_peak * 1e-3, 1) + " kN",
                    halo() + svg_attribute("text-anchor", "middle") +
                        svg_attribute("font-size", "11") + svg_attribute("fill", "#8a4b00"));
}

} // namespace

std::string pier_picture(const Masonry& masonry, const LoadInput& load,
                         const dem::Layout& layout, const PushedWall& wall)
{
    constexpr double kWide = 900.0, kHigh = 700.0; // [px], at most
    const dem::Region extent = wall_extent(masonry);
    const double length = extent.x1 - extent.x0, height = extent.z1 - extent.z0;
    const Places place{extent, std::min(kWide / length, kHigh / height)};
    std::string body = draw_stones(layout, place);
    for (std::size_t i = 0; i < wall.piers.size(); ++i)
        body += draw_pier(wall.piers[i], i + 1, place);
    for (const SpandrelReading& s : wall.spandrels) body += draw_spandrel(s, place);
    const std::string title = "Piers under " + stress_text(wall.vertical_stress) +
                              ", pushed to the " + way_name(push_way(load).direction);
    body += svg_text({kMargin, 26.0}, title, "font-size=\"17\" font-weight=\"bold\"") +
            svg_text({kMargin, 46.0},
                     "N, V: compression and shear when the wall carries most; drift over the "
                     "pier's own height, at the end",
                     "font-size=\"12\"");
    return svg_page(std::max(kMargin * 2.0 + place.scale * length, 640.0),
                    kHead + place.scale * height + kMargin, title, body);
}

} // namespace app
