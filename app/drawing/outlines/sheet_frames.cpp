#include "app/drawing/outlines/sheet_frames.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr std::size_t kLeast = 2; ///< outlines within a frame

struct Box {
    double left = std::numeric_limits<double>::infinity(), right = -left, low = left,
           high = -left;

    void add(dem::Point p)
    {
        left = std::min(left, p.x), right = std::max(right, p.x);
        low = std::min(low, p.z), high = std::max(high, p.z);
    }
};

Box box_of(const RawOutline& outline)
{
    Box box;
    for (const dem::Point p : outline.corners) box.add(p);
    return box;
}

bool is_within(const Box& inner, const Box& outer, double by)
{
    return inner.left >= outer.left - by && inner.right <= outer.right + by &&
           inner.low >= outer.low - by && inner.high <= outer.high + by;
}

/// Whether two outlines but the one at `frame` touch, as stones do and the windows of a facade
/// do not.
bool some_touch(const RawDrawing& drawing, std::size_t frame, double by)
{
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < drawing.outlines.size(); ++i) {
        if (i == frame) continue;
        const Box b = box_of(drawing.outlines[i]);
        if (std::ranges::any_of(boxes, [&](const Box& other) {
                return b.left <= other.right + by && other.left <= b.right + by &&
                       b.low <= other.high + by && other.low <= b.high + by;
            }))
            return true;
        boxes.push_back(b);
    }
    return false;
}

/// Four corners, or five of which the last is the first, each at a corner of the box.
bool is_upright_rectangle(const RawOutline& outline, const Box& box)
{
    const std::vector<dem::Point>& c = outline.corners;
    const auto same = [](dem::Point a, dem::Point b) { return a.x == b.x && a.z == b.z; };
    const std::size_t n = c.size() == 5 && same(c.front(), c.back()) ? 4 : c.size();
    if (n != 4) return false;
    for (std::size_t i = 0; i < n; ++i) {
        const dem::Point p = c[i], next = c[(i + 1) % n];
        const bool at_corner =
            (p.x == box.left || p.x == box.right) && (p.z == box.low || p.z == box.high);
        if (!at_corner || same(p, next) || (p.x == next.x) == (p.z == next.z)) return false;
    }
    return true;
}

/// An outline that goes around everything; the number of outlines where none does.
std::size_t frame_of(const RawDrawing& drawing, double by)
{
    Box whole;
    for (const RawOutline& outline : drawing.outlines)
        for (const dem::Point p : outline.corners) whole.add(p);
    for (const RawLine& line : drawing.lines) whole.add(line.from), whole.add(line.to);
    std::size_t i = 0;
    for (; i < drawing.outlines.size(); ++i)
        if (const Box box = box_of(drawing.outlines[i]);
            is_within(whole, box, by) && is_upright_rectangle(drawing.outlines[i], box))
            break;
    return i;
}

} // namespace

void take_out_frames(RawDrawing& drawing, double snap)
{
    while (drawing.outlines.size() > kLeast) {
        const double by = snap / drawing.frame.unit;
        const std::size_t i = frame_of(drawing, by);
        if (i == drawing.outlines.size() || !some_touch(drawing, i, by)) return;
        drawing.notes.push_back("The rectangle of line " +
                                std::to_string(drawing.outlines[i].line) +
                                " goes around all stones and was taken for the page or its "
                                "frame.");
        drawing.outlines.erase(drawing.outlines.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

} // namespace app
