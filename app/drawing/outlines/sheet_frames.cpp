#include "app/drawing/outlines/sheet_frames.hpp"

#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {
namespace {

using dem::Region;

bool is_within(const Region& inner, const Region& outer, double by)
{
    return inner.x0 >= outer.x0 - by && inner.x1 <= outer.x1 + by &&
           inner.z0 >= outer.z0 - by && inner.z1 <= outer.z1 + by;
}

bool touch(const Region& a, const Region& b, double by)
{
    return a.x0 <= b.x1 + by && b.x0 <= a.x1 + by && a.z0 <= b.z1 + by && b.z0 <= a.z1 + by;
}

std::vector<Region> extents_of(const RawDrawing& drawing)
{
    std::vector<Region> extents;
    for (const RawOutline& outline : drawing.outlines)
        extents.push_back(dem::extent_of(outline.corners));
    return extents;
}

Region extent_of(const RawLine& line)
{
    return dem::extent_of(std::vector{line.from, line.to});
}

/// Each corner is one of the extent's, and the sides are level and upright by turns.
bool is_upright_rectangle(const RawOutline& outline, const Region& e)
{
    std::vector<dem::Point> c = outline.corners;
    if (c.size() == 5 && c.front().x == c.back().x && c.front().z == c.back().z) c.pop_back();
    for (std::size_t i = 0; i < c.size(); ++i) {
        const dem::Point p = c[i], next = c[(i + 1) % c.size()];
        const bool at_corner = (p.x == e.x0 || p.x == e.x1) && (p.z == e.z0 || p.z == e.z1);
        if (!at_corner || (p.x == next.x) == (p.z == next.z)) return false;
    }
    return c.size() == 4;
}

/// Whether the outlines other than the one at `frame` are two or more of which some touch.
bool some_touch(const std::vector<Region>& extents, std::size_t frame, double by)
{
    for (std::size_t i = 0; i < extents.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (i != frame && k != frame && touch(extents[i], extents[k], by)) return true;
    return false;
}

/// An outline that goes around everything else.
std::optional<std::size_t> frame_of(const RawDrawing& drawing, double by)
{
    const std::vector<Region> extents = extents_of(drawing);
    if (extents.empty()) return {};
    Region whole = extents.front();
    for (const Region& e : extents) whole = dem::join(whole, e);
    for (const RawLine& line : drawing.lines) whole = dem::join(whole, extent_of(line));
    for (std::size_t i = 0; i < extents.size(); ++i) {
        if (!is_within(whole, extents[i], by) ||
            !is_upright_rectangle(drawing.outlines[i], extents[i]))
            continue;
        const bool ends_within =
            !drawing.lines.empty() && std::ranges::all_of(drawing.lines, [&](const RawLine& l) {
                return is_within(extent_of(l), extents[i], -by);
            });
        if (ends_within || some_touch(extents, i, by)) return i;
    }
    return {};
}

/// Whether the middle of the line lies within, and not on a side.
bool divides(const RawLine& line, const RawOutline& outline, double by)
{
    const dem::Point middle{0.5 * (line.from.x + line.to.x), 0.5 * (line.from.z + line.to.z)};
    const std::vector<dem::Point>& c = outline.corners;
    if (!dem::is_inside(c, middle)) return false;
    for (std::size_t i = 0; i < c.size(); ++i)
        if (dem::distance_to_segment(middle, c[i], c[(i + 1) % c.size()]) <= by) return false;
    return true;
}

void note_line(RawDrawing& drawing, int line, const std::string& what)
{
    drawing.notes.push_back("The outline of line " + std::to_string(line) + what);
}

} // namespace

void take_out_frames(RawDrawing& drawing, double snap)
{
    while (const auto i = frame_of(drawing, snap / drawing.frame.unit)) {
        note_line(drawing, drawing.outlines[*i].line,
                  " goes around all stones and was taken for the page or its frame.");
        drawing.outlines.erase(drawing.outlines.begin() + static_cast<std::ptrdiff_t>(*i));
    }
}

void divide_outlines(RawDrawing& drawing, double snap)
{
    std::vector<RawLine> sides;
    std::erase_if(drawing.outlines, [&](const RawOutline& outline) {
        const Region e = dem::extent_of(outline.corners);
        if (std::ranges::none_of(drawing.lines, [&](const RawLine& line) {
                return touch(extent_of(line), e, 0.0) &&
                       divides(line, outline, snap / drawing.frame.unit);
            }))
            return false;
        note_line(drawing, outline.line, " is divided by lines, and its sides count as lines.");
        const std::vector<dem::Point>& c = outline.corners;
        for (std::size_t i = 0; i < c.size(); ++i)
            if (const dem::Point to = c[(i + 1) % c.size()]; c[i].x != to.x || c[i].z != to.z)
                sides.push_back({c[i], to, outline.layer, outline.line});
        return true;
    });
    for (RawLine& side : sides) add_line(drawing, std::move(side));
}

} // namespace app
