#include "app/drawing/svg_paints.hpp"

#include "app/drawing/outlines/sides.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

namespace app {
namespace {

using Corners = std::vector<dem::Point>;

/// Whether two outlines have the same corners one after the other, from any corner on and in
/// either direction.
bool coincide(const Corners& a, const Corners& b, double tolerance)
{
    const std::size_t n = a.size();
    if (n != b.size()) return false;
    for (const bool backwards : {false, true})
        for (std::size_t from = 0; from < n; ++from) {
            std::size_t k = 0;
            while (k < n &&
                   distance(a[k], b[(from + (backwards ? n - k : k)) % n]) <= tolerance)
                ++k;
            if (k == n) return true;
        }
    return false;
}

/// The corners without those on the straight line between their neighbours: programs begin an
/// outline in the middle of a side.
Corners without_straight(const Corners& all, double tolerance)
{
    Corners kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const dem::Point before = kept.empty() ? all.back() : kept.back(),
                         after = all[(i + 1) % all.size()];
        if (nearest_on_segment(all[i], before, after).distance > tolerance)
            kept.push_back(all[i]);
    }
    return kept;
}

double left_of(const Corners& corners)
{
    return std::ranges::min(corners, {}, &dem::Point::x).x;
}

/// Outlines that have only a stroke, by their left ends.
std::multimap<double, std::size_t> lines_of(const RawDrawing& drawing,
                                            const std::vector<SvgPaint>& paints)
{
    std::multimap<double, std::size_t> lines;
    for (std::size_t i = 0; i < paints.size(); ++i)
        if (paints[i].stroked && !paints[i].filled)
            lines.emplace(left_of(drawing.outlines[i].corners), i);
    return lines;
}

void note_joined(RawDrawing& drawing, std::size_t joined, std::size_t moved)
{
    if (joined == 0) return;
    std::string note = counted(joined, "stone has its fill and its stroke",
                               "stones have their fill and their stroke") +
                       " as two outlines that coincide; " +
                       (joined == 1 ? "they were read as one." : "each two were read as one.");
    if (moved > 0)
        note += " " + counted(moved, "stroke is", "strokes are") +
                " on another layer than the fill, whose layer counts.";
    drawing.notes.push_back(std::move(note));
}

} // namespace

void join_paints(RawDrawing& drawing, const std::vector<SvgPaint>& paints, double snap)
{
    const double tolerance = snap / drawing.frame.unit;
    std::vector<RawOutline>& outlines = drawing.outlines;
    std::multimap<double, std::size_t> lines = lines_of(drawing, paints);
    std::vector<char> is_joined(outlines.size());
    std::size_t joined = 0, moved = 0;
    for (std::size_t i = 0; i < paints.size(); ++i) {
        if (!paints[i].filled || paints[i].stroked) continue;
        const double left = left_of(outlines[i].corners);
        const auto last = lines.upper_bound(left + tolerance);
        const Corners corners = without_straight(outlines[i].corners, tolerance);
        const auto line =
            std::find_if(lines.lower_bound(left - tolerance), last, [&](const auto& l) {
                const Corners& stroke = outlines[l.second].corners;
                return coincide(corners, without_straight(stroke, tolerance), tolerance);
            });
        if (line == last) continue;
        const std::size_t stroke = line->second;
        lines.erase(line);
        is_joined[stroke] = 1;
        ++joined;
        if (outlines[stroke].layer != outlines[i].layer) ++moved;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < outlines.size(); ++i)
        if (!is_joined[i]) std::swap(outlines[kept++], outlines[i]);
    outlines.resize(kept);
    note_joined(drawing, joined, moved);
}

} // namespace app
