#include "app/scene/scene_picture.hpp"

#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_body.hpp"
#include "app/output/picture/wall_view.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace app {
namespace {

using dem::FaceKind;
using dem::Point;

constexpr double kMargin = 24.0, kSizeRoom = 56.0, kTop = 76.0; // [px]
constexpr double kWide = 900.0, kHigh = 680.0;                  // of the wall, at most [px]
constexpr double kLegendRow = 22.0;                             // [px]
constexpr const char* kBeamTint = "#d3d6da";
constexpr const char* kEdge = "stroke=\"#6b6459\" stroke-width=\"0.9\"";
constexpr const char* kSmall = "font-size=\"12\" fill=\"#444\"";

struct Style {
    FaceKind kind;
    const char* colour;
    double width;     ///< [px]
    const char* dash; ///< empty: a full line
    const char* name;
};
constexpr std::array kStyles = {
    Style{FaceKind::bed_joint, "#0072B2", 1.6, "", "bed joints"},
    Style{FaceKind::head_joint, "#D55E00", 1.6, "", "head joints"},
    Style{FaceKind::unit_crack, "#A50F5A", 1.2, "3 3", "potential cracks in units"},
    Style{FaceKind::beam_joint, "#6a51a3", 2.6, "", "faces at the loading beam"},
    Style{FaceKind::base_joint, "#117733", 2.6, "", "joints at the base"}};

std::string dashes(const Style& s)
{
    return svg_stroke(s.colour, s.width) +
           (*s.dash == '\0' ? "" : svg_attribute("stroke-dasharray", s.dash));
}

std::vector<Pixel> placed(const std::vector<Point>& outline, const WallView& view)
{
    std::vector<Pixel> pixels;
    for (const Point p : outline) pixels.push_back(view.place(p));
    return pixels;
}

/// Layers in the order in which they are met.
std::vector<std::string> layers_of(std::span<const DrawnBlock> units)
{
    std::vector<std::string> layers;
    for (const DrawnBlock& u : units)
        if (std::ranges::find(layers, u.layer) == layers.end()) layers.push_back(u.layer);
    return layers;
}

const char* tint_of(const std::vector<std::string>& layers, const std::string& layer)
{
    const auto at = std::ranges::find(layers, layer) - layers.begin();
    return kKindTints[static_cast<std::size_t>(at) % kKindTints.size()];
}

std::string draw_units(std::span<const DrawnBlock> units, const WallView& view)
{
    const std::vector<std::string> layers = layers_of(units);
    std::string drawn;
    for (const DrawnBlock& u : units)
        drawn +=
            svg_polygon(placed(u.outline, view),
                        svg_attribute("fill", tint_of(layers, u.layer)) + std::string(kEdge));
    return drawn;
}

std::string draw_numbers(std::span<const DrawnBlock> units, const WallView& view)
{
    std::string drawn;
    for (std::size_t k = 0; k < units.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        const double side =
            std::sqrt(dem::polygon_area(units[k].outline)) * view.pixels_per_metre;
        const double size =
            std::min({13.0, 0.6 * side, 1.4 * side / static_cast<double>(number.size())});
        const Pixel at = view.place(dem::polygon_centre(units[k].outline));
        drawn +=
            svg_text({at.x, at.y + 0.35 * size}, number,
                     svg_attribute("font-size", svg_number(size)) + "text-anchor=\"middle\"");
    }
    return svg_group("fill=\"#222\" stroke=\"#fff\" stroke-opacity=\"0.75\" "
                     "stroke-width=\"3\" paint-order=\"stroke\"",
                     drawn);
}

std::string draw_faces(const dem::Layout& layout, const WallView& view)
{
    std::string drawn;
    for (const Style& s : kStyles) {
        std::string lines;
        for (const dem::Face& f : layout.faces)
            if (f.kind == s.kind) lines += svg_line(view.place(f.from), view.place(f.to), "");
        drawn += svg_group(dashes(s) + "stroke-linecap=\"round\"", lines);
    }
    return drawn;
}

/// Hatching below a piece of floor that carries.
std::string hatch(Pixel left, Pixel right)
{
    constexpr double kStep = 7.0, kDepth = 8.0; // [px]
    std::string lines = svg_line(left, right, svg_attribute("stroke-width", "1.8"));
    for (double x = left.x + 0.5 * kStep; x < right.x; x += kStep)
        lines += svg_line({x, left.y}, {x - kDepth, left.y + kDepth}, "");
    return lines;
}

/// Whether a side or a corner of a block cannot move sideways, clamped below or not.
bool is_held(const dem::Block& b)
{
    return dem::is_hinged(b.motion) || b.motion == dem::Motion::clamped_bottom_held_right ||
           b.motion == dem::Motion::clamped_bottom_held_left;
}

std::string draw_supports(const dem::Layout& layout, const WallView& view)
{
    std::string drawn;
    for (const dem::Block& b : layout.blocks) {
        if (dem::is_clamped(b.motion)) {
            const std::vector<Point> corners = dem::corners_of(b);
            for (std::size_t i = 0; i < corners.size(); ++i) {
                const Point p = corners[i], q = corners[(i + 1) % corners.size()];
                constexpr double kFloor = 1e-6; // [m]
                if (std::abs(p.z) < kFloor && std::abs(q.z) < kFloor && p.x < q.x)
                    drawn += hatch(view.place(p), view.place(q));
            }
        }
        if (is_held(b)) { // a roller at the toe
            const bool left = dem::is_held_left(b.motion);
            const Pixel at = view.place({left ? b.x0 : b.x1, b.z0});
            const double away = left ? -11.0 : 11.0; // [px]
            const std::array<Pixel, 3> roller = {at, Pixel{at.x + away, at.y - 6.0},
                                                 Pixel{at.x + away, at.y + 6.0}};
            drawn += svg_polygon(roller, "");
        }
    }
    for (const dem::Face& f : layout.faces)
        if (f.kind == FaceKind::base_joint)
            drawn += hatch(view.place(f.from), view.place(f.to));
    return svg_group(svg_stroke("#444", 0.9), drawn);
}

std::string side_text(double metres) { return number(metres * 1e3, 6) + " mm"; }

/// A line from end to end with its length.
std::string draw_size(Pixel from, Pixel to, const std::string& text)
{
    const bool level = from.y == to.y;
    std::string lines = svg_line(from, to, "");
    for (const Pixel end : {from, to})
        lines += level ? svg_line({end.x, end.y - 5}, {end.x, end.y + 5}, "")
                       : svg_line({end.x - 5, end.y}, {end.x + 5, end.y}, "");
    const Pixel middle{0.5 * (from.x + to.x), 0.5 * (from.y + to.y)};
    const std::string turn =
        level ? ""
              : svg_attribute("transform", "rotate(-90 " + svg_number(middle.x - 8) + ' ' +
                                               svg_number(middle.y) + ')');
    return svg_group(svg_stroke("#444", 1.0), lines) +
           svg_text({level ? middle.x : middle.x - 8, level ? middle.y + 17 : middle.y}, text,
                    std::string(kSmall) + " text-anchor=\"middle\" " + turn);
}

struct LegendItem {
    std::string sample, text;
};

/// Joints and faces by kind. A joint between two blocks may have several faces, and counts
/// once.
std::array<int, kStyles.size()> count_faces(const dem::Layout& layout)
{
    std::array<int, kStyles.size()> n{};
    std::vector<int> seen(layout.n_joints + 1, 0);
    for (const dem::Face& f : layout.faces) {
        const bool joint = f.kind == FaceKind::bed_joint || f.kind == FaceKind::head_joint;
        if (!joint || seen.at(f.id)++ == 0) ++n.at(static_cast<std::size_t>(f.kind));
    }
    return n;
}

std::string stone_text(const std::string& layer, const std::vector<std::string>& layers)
{
    const bool unnamed = std::ranges::find(layers, "") != layers.end();
    const bool own = layer.empty() || (layer == "wall" && !unnamed);
    return own ? "the wall's stone" : "layer " + layer;
}

std::vector<LegendItem> legend_items(const dem::Layout& layout,
                                     std::span<const DrawnBlock> units)
{
    std::vector<LegendItem> items;
    const auto faces = count_faces(layout);
    for (const Style& s : kStyles)
        if (const int n = faces.at(static_cast<std::size_t>(s.kind)); n > 0)
            items.push_back(
                {svg_line({0, 0}, {34, 0}, dashes(s)), std::to_string(n) + " " + s.name});
    if (const auto clamped =
            std::ranges::count_if(layout.blocks, dem::is_clamped, &dem::Block::motion);
        clamped > 0)
        items.push_back({svg_group(svg_stroke("#444", 0.9), hatch({0, -4}, {34, -4})),
                         std::to_string(clamped) + " blocks held on the floor"});
    const std::vector<std::string> layers = layers_of(units);
    for (const std::string& layer : layers)
        items.push_back(
            {svg_rectangle({2, -7}, 30, 14,
                           svg_attribute("fill", tint_of(layers, layer)) + std::string(kEdge)),
             std::to_string(std::ranges::count(units, layer, &DrawnBlock::layer)) +
                 " units of " + stone_text(layer, layers)});
    return items;
}

std::string draw_legend(const std::vector<LegendItem>& items, double top, double column)
{
    std::string drawn;
    for (std::size_t k = 0; k < items.size(); ++k) {
        const double x = kMargin + column * static_cast<double>(k % 3);
        const double y = top + kLegendRow * static_cast<double>(k / 3);
        drawn += svg_group(svg_attribute("transform", "translate(" + svg_number(x) + ' ' +
                                                          svg_number(y) + ')'),
                           items[k].sample + svg_text({42, 4.5}, items[k].text, ""));
    }
    return drawn;
}

} // namespace

std::string scene_picture(const dem::Layout& layout, std::span<const DrawnBlock> units,
                          const std::string& title, const std::string& below)
{
    double x0 = 0.0, x1 = 0.0, top = 0.0; // [m]
    for (const dem::Block& b : layout.blocks) {
        x0 = std::min(x0, b.x0);
        x1 = std::max(x1, b.x1);
        top = std::max(top, b.z1);
    }
    WallView view;
    view.pixels_per_metre = std::min(kWide / (x1 - x0), kHigh / top);
    const double wide = (x1 - x0) * view.pixels_per_metre, high = top * view.pixels_per_metre;
    const double page = std::max(
        {wide + 2 * kMargin + kSizeRoom, 840.0, text_width(title, 18.0) + 2 * kMargin});
    view.origin = {0.5 * (page - wide + kSizeRoom) - x0 * view.pixels_per_metre, kTop + high};

    std::string body =
        svg_text({kMargin, 32.0}, title, "font-size=\"18\" font-weight=\"bold\"") +
        svg_text({kMargin, 54.0}, below, "fill=\"#444\"");
    body += draw_units(units, view);
    if (static_cast<std::size_t>(layout.beam) < layout.blocks.size()) {
        const dem::Block& beam = layout.blocks[layout.beam];
        body += svg_polygon(placed(dem::corners_of(beam), view),
                            svg_attribute("fill", kBeamTint) + std::string(kEdge)) +
                svg_text({view.place(dem::centre_of(beam)).x,
                          view.place(dem::centre_of(beam)).y + 4.0},
                         "loading beam", std::string(kSmall) + " text-anchor=\"middle\"");
    }
    body += draw_supports(layout, view) + draw_faces(layout, view) + draw_numbers(units, view);
    const Pixel left = view.place({x0, 0.0}), right = view.place({x1, 0.0});
    body += draw_size({left.x, left.y + 26}, {right.x, right.y + 26}, side_text(x1 - x0)) +
            draw_size({left.x - 24, left.y}, {left.x - 24, view.place({0.0, layout.height}).y},
                      side_text(layout.height));
    const std::vector<LegendItem> items = legend_items(layout, units);
    const double legend = left.y + 76.0;
    body += draw_legend(items, legend, (page - 2 * kMargin) / 3.0);
    const auto rows = static_cast<double>((items.size() + 2) / 3);
    return svg_page(page, legend + rows * kLegendRow + 8.0, title, body);
}

} // namespace app
