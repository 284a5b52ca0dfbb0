#include "app/output/picture/wall_svg.hpp"

#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_body.hpp"
#include "app/output/picture/wall_legend.hpp"
#include "app/output/picture/wall_marks.hpp"
#include "app/output/picture/wall_view.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace app {

namespace {

constexpr double kPageMargin = 24.0, kPageWidth = 1000.0, kMostPanelHeight = 640.0; // [px]
constexpr double kArrowLength = 44.0; // of the horizontal load [px]
constexpr double kBareRoom = 16.0;    // on the other side [px]
constexpr double kArrowRoom = 50.0;   // above the wall, for the vertical load [px]
constexpr double kGroundRoom = 40.0;  // below the wall, for the hatching and the scale bar [px]
constexpr double kAway = 4.0;         // between an arrow and what it loads [px]
constexpr double kFullStone = 34.0;   // height of a stone that takes marks of full size [px]
constexpr const char* kArrowColour = "#222";
constexpr const char* kCentred = "text-anchor=\"middle\" font-size=\"12\"";

/// One panel: a wall and how it is named and drawn.
struct Panel {
    const dem::Snapshot& wall;
    std::string name;
    WallView view;
    double left = 0.0; ///< [px]
};

/// The measures that the panels share.
struct Page {
    double panel_width = 0.0;       ///< [px]
    double top = 0.0, height = 0.0; ///< of the panels [px]
    double pixels_per_metre = 1.0;
    Pixel origin; ///< of x = 0, z = 0, from the left of a panel and the top of the page
    WallBox rest; ///< undeformed walls
    MarkSizes marks;
    double widest_force = 0.0; ///< of a face [N]
    double largest_load = 0.0; ///< horizontal, of the panels [N]
    double mark_size = 1.0;    ///< WallView::mark_size
};

std::string arrow(Pixel from, Pixel to)
{
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    const Pixel t{dx / length, dy / length};
    constexpr double kHead = 8.0, kHalf = 3.6;
    const Pixel neck{to.x - kHead * t.x, to.y - kHead * t.y};
    const std::array<Pixel, 3> head = {to, Pixel{neck.x - kHalf * t.y, neck.y + kHalf * t.x},
                                       Pixel{neck.x + kHalf * t.y, neck.y - kHalf * t.x}};
    return svg_line(from, neck, svg_stroke(kArrowColour, 1.8)) +
           svg_polygon(head, svg_attribute("fill", kArrowColour));
}

std::string draw_ground(const Page& page, const WallView& view)
{
    const Pixel left = view.place({page.rest.low.x, page.rest.low.z});
    const Pixel right = view.place({page.rest.high.x, page.rest.low.z});
    std::string hatch;
    constexpr double kBeyond = 14.0, kStep = 9.0, kDepth = 9.0; // [px]
    for (double x = left.x - kBeyond + kDepth; x <= right.x + kBeyond; x += kStep)
        hatch += svg_line({x, left.y}, {x - kDepth, left.y + kDepth}, "");
    return svg_group(svg_stroke("#777", 0.9), hatch) + svg_line({left.x - kBeyond, left.y},
                                                                {right.x + kBeyond, left.y},
                                                                svg_stroke("#444", 1.6));
}

/// The loading beam as drawn; the whole wall if there is none.
WallBox loaded_box(const dem::Snapshot& wall, double scale)
{
    std::vector<dem::BlockState> beam;
    for (const dem::BlockState& block : wall.blocks)
        if (block.course == 0) beam.push_back(block);
    return box_of(beam.empty() ? wall.blocks : beam, scale);
}

std::string draw_vertical_load(Pixel left, Pixel right, std::string_view label)
{
    if (label.empty()) return {};
    constexpr int kArrows = 5;
    const double tip = left.y - kAway;
    std::string drawn;
    for (int i = 0; i < kArrows; ++i) {
        const double x = left.x + (right.x - left.x) * (i + 0.5) / kArrows;
        drawn += arrow({x, tip - 20.0}, {x, tip});
    }
    return drawn + svg_text({(left.x + right.x) / 2, tip - 26.0}, label, kCentred);
}

/// The horizontal load of a panel [kN]; what is nothing beside the largest is written as
/// nothing.
std::string load_text(double force, const Page& page)
{
    constexpr double kNothing = 1e-3; // of the largest
    return std::abs(force) <= kNothing * page.largest_load
               ? fixed(0.0, 1)
               : never_rounded_away(force * 1e-3, 1);
}

/// From the wall to the far end of the horizontal arrow or of its force [px].
double load_room(double force, const Page& page)
{
    return kAway +
           std::max(kArrowLength,
                    text_width(load_text(std::abs(force), page) + " kN", 12.0) + kAway) +
           8.0;
}

std::string draw_horizontal_load(const Panel& panel, const Page& page, Pixel tip, double sign)
{
    const double away = sign * kAway;
    if (panel.wall.force == 0.0) return {};
    return arrow({tip.x - away - sign * kArrowLength, tip.y}, {tip.x - away, tip.y}) +
           svg_text({tip.x - 2 * away, tip.y - 9.0},
                    load_text(std::abs(panel.wall.force), page) + " kN",
                    svg_attribute("text-anchor", sign > 0.0 ? "end" : "start") +
                        "font-size=\"12\"");
}

std::string draw_loads(const Panel& panel, const Page& page, const WallPictureText& text)
{
    const WallBox beam = loaded_box(panel.wall, panel.view.scale);
    const double z = std::clamp(text.load_height, beam.low.z, beam.high.z);
    const bool to_right = panel.wall.force >= 0.0;
    const Pixel tip = panel.view.place({to_right ? beam.low.x : beam.high.x, z});
    return (text.pushed ? draw_horizontal_load(panel, page, tip, to_right ? 1.0 : -1.0) : "") +
           draw_vertical_load(panel.view.place({beam.low.x, beam.high.z}),
                              panel.view.place(beam.high), text.vertical_load);
}

std::string draw_scale_bar(const Page& page, const WallView& view)
{
    double length = 1.0; // [m] the largest round length below a third of the wall
    const double room = (page.rest.high.x - page.rest.low.x) / 3.0;
    for (const double step : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0})
        if (step <= room) length = step;
    const Pixel a = view.place({page.rest.low.x, page.rest.low.z});
    const Pixel left{a.x, a.y + 24.0}, right{a.x + length * view.pixels_per_metre, a.y + 24.0};
    std::string bar = svg_line(left, right, "");
    for (const Pixel end : {left, right})
        bar += svg_line({end.x, end.y - 4}, {end.x, end.y + 4}, "");
    return svg_group(svg_stroke("#222", 1.4), bar) + svg_text({right.x + 8.0, right.y + 4.0},
                                                              number(length * 1e3, 6) + " mm",
                                                              "font-size=\"12\"");
}

std::string draw_heading(const Panel& panel, const Page& page, const WallPictureText& text)
{
    const dem::Snapshot& wall = panel.wall;
    const std::string numbers =
        never_rounded_away(wall.displacement * 1e3, 1) + " mm,  drift " +
        never_rounded_away(100.0 * fragility::drift(wall.displacement, text.load_height), 2) +
        " %,  " + load_text(wall.force, page) + (text.pushed ? " kN" : " kN at the base");
    const double after_name = panel.left + text_width(panel.name, 15.0) + 18.0;
    return svg_text({panel.left, page.top - 30.0}, panel.name,
                    "font-size=\"15\" font-weight=\"bold\"") +
           svg_text({after_name, page.top - 30.0}, numbers, "font-size=\"15\"") +
           svg_text({panel.left, page.top - 11.0},
                    "displacements drawn × " + number(panel.view.scale, 6), "fill=\"#666\"");
}

std::string draw_panel(const Panel& panel, const Page& page, const WallPictureText& text)
{
    const dem::Snapshot& wall = panel.wall;
    const WallView& view = panel.view;
    return draw_heading(panel, page, text) +
           svg_window({panel.left, page.top}, page.panel_width, page.height,
                      draw_undeformed(wall, view) + draw_ground(page, view) +
                          draw_blocks(wall, view, text.tints) +
                          draw_thrust(wall, view, page.widest_force) +
                          draw_openings(wall, view, page.marks) +
                          draw_slips(wall, view, page.marks) + draw_cracks(wall, view) +
                          draw_crushed(wall, view) + draw_loads(panel, page, text) +
                          draw_scale_bar(page, view));
}

/// The larger movement sets the factor for both; the other keeps its own if it would then not
/// be seen.
std::array<double, 2> drawing_scales(const dem::Snapshot& at_peak, const dem::Snapshot& at_end)
{
    const double peak = drawing_scale(at_peak), end = drawing_scale(at_end);
    const double both = std::min(peak, end);
    const WallBox rest = box_of(at_peak.blocks, 0.0);
    const double seen = 0.02 * (rest.high.z - rest.low.z); // [m]
    const auto pick = [&](const dem::Snapshot& wall, double own) {
        return both * largest_displacement(wall) >= seen ? both : own;
    };
    return {pick(at_peak, peak), pick(at_end, end)};
}

/// Walls that flew apart are cut off at half their size around them.
WallBox cut_off(const WallBox& rest, const WallBox& drawn)
{
    const double most = 0.5 * std::max(rest.high.x - rest.low.x, rest.high.z - rest.low.z);
    return {{std::max(drawn.low.x, rest.low.x - most), rest.low.z},
            {std::min(drawn.high.x, rest.high.x + most),
             std::min(drawn.high.z, rest.high.z + most)}};
}

/// Smallest height of a stone [m].
double smallest_stone(const dem::Snapshot& wall)
{
    double smallest = std::numeric_limits<double>::infinity();
    for (const dem::BlockState& block : wall.blocks) {
        if (block.course == 0) continue;
        const WallBox box = box_of({&block, 1}, 0.0);
        smallest = std::min(smallest, box.high.z - box.low.z);
    }
    return smallest;
}

Page lay_out(const Panel& peak, const Panel& end, int panels, const WallPictureText& text)
{
    Page page;
    page.panel_width = (kPageWidth - (panels + 1) * kPageMargin) / panels;
    page.largest_load = std::max(std::abs(peak.wall.force), std::abs(end.wall.force));
    page.rest = join(box_of(peak.wall.blocks, 0.0), box_of(end.wall.blocks, 0.0));
    const WallBox drawn =
        cut_off(page.rest, join(page.rest, join(box_of(peak.wall.blocks, peak.view.scale),
                                                box_of(end.wall.blocks, end.view.scale))));
    const double wide = drawn.high.x - drawn.low.x, high = drawn.high.z - drawn.low.z;
    constexpr double kAround = kArrowRoom + kGroundRoom; // [px]
    const auto [least, most] = std::minmax(peak.wall.force, end.wall.force);
    const double loaded = std::max(load_room(least, page), load_room(most, page));
    const double left = most >= 0.0 ? loaded : kBareRoom;
    const double right = least < 0.0 ? loaded : kBareRoom;
    page.pixels_per_metre =
        std::min((page.panel_width - left - right) / wide, (kMostPanelHeight - kAround) / high);
    page.top = text.title.empty() ? 56.0 : 94.0;
    page.height = high * page.pixels_per_metre + kAround;
    const double spare = page.panel_width - left - right - wide * page.pixels_per_metre;
    page.origin = {left + (panels == 1 ? 0.5 * spare : 0.0) -
                       drawn.low.x * page.pixels_per_metre,
                   page.top + page.height - kGroundRoom + drawn.low.z * page.pixels_per_metre};
    page.marks = {text.mark_above,
                  std::max(largest_slip(peak.wall, text.mark_above),
                           largest_slip(end.wall, text.mark_above)),
                  any_crushed(peak.wall) || any_crushed(end.wall)};
    page.mark_size =
        std::clamp(smallest_stone(peak.wall) * page.pixels_per_metre / kFullStone, 0.3, 1.0);
    page.widest_force = std::max(largest_compression(peak.wall), largest_compression(end.wall));
    return page;
}

/// Whether the push ends at its largest force, or so near to it that both pictures would be
/// one.
bool same_picture(const dem::Snapshot& peak, const dem::Snapshot& end)
{
    constexpr double kNear = 0.02;
    const auto near = [](double a, double b) { return std::abs(a - b) <= kNear * std::abs(b); };
    return near(peak.displacement, end.displacement) && near(peak.force, end.force);
}

} // namespace

std::string wall_picture(const dem::Snapshot& at_peak, const dem::Snapshot& at_end,
                         const WallPictureText& text)
{
    if (!(text.load_height > 0.0) || !(text.mark_above > 0.0))
        throw std::invalid_argument("wall picture: load height and threshold must be positive");
    const std::array<double, 2> scales = drawing_scales(at_peak, at_end);
    std::vector<Panel> panels;
    if (same_picture(at_peak, at_end)) {
        panels.push_back({at_end, text.both_name, {scales[1], 1.0, {}, 1.0}});
    } else {
        panels.push_back({at_peak, text.peak_name, {scales[0], 1.0, {}, 1.0}});
        panels.push_back({at_end, text.end_name, {scales[1], 1.0, {}, 1.0}});
    }
    const Page page =
        lay_out(panels.front(), panels.back(), static_cast<int>(panels.size()), text);

    std::string body =
        svg_text({kPageMargin, 34.0}, text.title, "font-size=\"18\" font-weight=\"bold\"");
    double left = kPageMargin;
    for (Panel& panel : panels) {
        panel.left = left;
        panel.view.pixels_per_metre = page.pixels_per_metre;
        panel.view.mark_size = page.mark_size;
        panel.view.origin = {panel.left + page.origin.x, page.origin.y};
        body += draw_panel(panel, page, text);
        left += page.panel_width + kPageMargin;
    }
    const double legend_top = page.top + page.height + 14.0;
    body += draw_wall_legend({kPageMargin, legend_top}, kPageWidth - 2 * kPageMargin,
                             page.marks, page.widest_force, page.mark_size, text.tints);
    return svg_page(kPageWidth, legend_top + wall_legend_height(page.marks, text.tints) + 16.0,
                    text.title.empty() ? "A wall that is pushed" : text.title, body);
}

} // namespace app
