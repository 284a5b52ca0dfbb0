#include "app/drawing/outlines/raw_drawing.hpp"

#include "app/drawing/outlines/sides.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace app {

void state_unit(RawDrawing& drawing, double unit, std::string_view name)
{
    drawing.own_unit = unit;
    drawing.own_unit_name = name;
    if (!drawing.frame.unit_given && unit > 0.0) drawing.frame.unit = unit;
}

void refuse(const DrawingFrame& frame, int line, std::string_view why)
{
    throw ConfigError(frame.file, line, "", std::string(why) + frame.part);
}

std::string raw_coordinates(const DrawingFrame& frame, dem::Point at)
{
    const double second = frame.z_down ? -at.z : at.z;
    return "(" + number(at.x, 8) + ", " + number(second + 0.0, 8) + ")";
}

std::string coordinates(const DrawingFrame& frame, dem::Point at)
{
    // the conversion to metres and back must not turn 0.3 into 0.30000000000000004, nor 2 into
    // 1.9999999
    const auto back = [&](double metres, double origin) {
        const double value = metres / frame.unit + origin;
        return std::abs(value) < 1e-9 ? 0.0 : value;
    };
    return raw_coordinates(frame, {back(at.x, frame.origin.x), back(at.z, frame.origin.z)});
}

std::string millimetres(double length)
{
    return number(length * 1e3, length < 0.1 ? 3 : 6) + " mm";
}

dem::Point checked_point(const DrawingFrame& frame, int line, double x, double z)
{
    constexpr double kLargest = 1e9; // 1000 km in mm
    if (!(std::abs(x) <= kLargest && std::abs(z) <= kLargest)) {
        refuse(
            frame, line,
            "a coordinate is not a number between -1e9 and 1e9; draw the wall near the origin");
    }
    return {x + 0.0, z + 0.0}; // no -0.0
}

namespace {

/// Whether the corners from `from` on lie on the first sides of the outline, one after the
/// other.
bool runs_over_first_sides(const std::vector<dem::Point>& corners, std::size_t from,
                           double tolerance)
{
    std::size_t side = 0;
    for (std::size_t i = from; i < corners.size(); ++i)
        while (nearest_on_segment(corners[i], corners[side], corners[side + 1]).distance >
               tolerance) {
            ++side; // only from the end of the one before
            if (side >= from || distance(corners[i - 1], corners[side]) > tolerance)
                return false;
        }
    return true;
}

/// The number of corners up to where an outline comes back to its first corner and runs on over
/// its own first sides.
std::size_t corners_without_rest(const std::vector<dem::Point>& corners, double tolerance)
{
    for (std::size_t i = 3; i + 1 < corners.size(); ++i)
        if (distance(corners[i], corners.front()) <= tolerance &&
            runs_over_first_sides(corners, i, tolerance))
            return i;
    return corners.size();
}

} // namespace

void add_outline(RawDrawing& drawing, RawOutline outline, bool closed, double snap)
{
    constexpr std::size_t kLeastCorners = 4; // of an open outline that may be a stone
    const DrawingFrame& frame = drawing.frame;
    MendedOutlines& mended = drawing.mended;
    std::vector<dem::Point>& corners = outline.corners;
    if (drawing.outlines.size() >= kMostBlocks) {
        refuse(frame, outline.line,
               "has more than " + std::to_string(kMostBlocks) +
                   " blocks; draw a part of the wall");
    }
    if (corners.empty()) refuse(frame, outline.line, "an outline has no corners; delete it");
    const std::size_t ring = corners_without_rest(corners, snap / frame.unit);
    if (ring < corners.size()) {
        const bool runs_on = distance(corners.front(), corners.back()) * frame.unit > snap;
        if (runs_on && mended.run_on++ == 0) mended.first_run_on = outline.line;
        corners.resize(ring);
        closed = true;
    }
    const dem::Point first = corners.front(), last = corners.back();
    const double gap = distance(first, last) * frame.unit;
    if (!closed && corners.size() == 2)
        return add_line(drawing, {first, last, outline.layer, outline.line});
    if (!closed && (gap > snap || corners.size() < 3)) {
        const bool can_be_closed = corners.size() >= kLeastCorners;
        if (!can_be_closed || !frame.close_outlines)
            refuse(frame, outline.line,
                   "this outline is open: it begins at " + raw_coordinates(frame, first) +
                       " and ends at " + raw_coordinates(frame, last) + ", " +
                       millimetres(gap) +
                       " apart; close it, or delete it if it is not a block" +
                       (can_be_closed ? "; wall.close_outlines = yes would close it, and all "
                                        "others, by a straight side"
                                      : ""));
        ++mended.closed;
        if (gap > mended.widest) {
            mended.widest = gap;
            mended.widest_line = outline.line;
        }
    }
    if (corners.size() > 1 && gap <= snap) corners.pop_back();
    drawing.outlines.push_back(std::move(outline));
}

void add_line(RawDrawing& drawing, RawLine line)
{
    if (drawing.lines.size() >= kMostCorners) {
        refuse(drawing.frame, line.line,
               "has more than " + std::to_string(kMostCorners) +
                   " lines; draw a part of the wall");
    }
    drawing.lines.push_back(std::move(line));
}

void note_mended(RawDrawing& drawing)
{
    const MendedOutlines& m = drawing.mended;
    if (m.run_on > 0) {
        const bool one = m.run_on == 1;
        drawing.notes.push_back(
            counted(m.run_on, "outline runs on over its", "outlines run on over their") +
            " own first sides once " + (one ? "it has" : "they have") + " closed (line " +
            std::to_string(m.first_run_on) + (one ? ")" : " and others)") +
            "; what runs on was left out.");
    }
    if (m.closed > 0) {
        const bool one = m.closed == 1;
        drawing.notes.push_back(counted(m.closed, "outline was", "outlines were") +
                                " open and " + (one ? "was" : "were") +
                                " closed by a straight side (wall.close_outlines); the " +
                                (one ? "" : "widest ") + "gap was " + millimetres(m.widest) +
                                ", of line " + std::to_string(m.widest_line) + ".");
    }
}

void note_ignored(RawDrawing& drawing, const std::map<std::string, std::size_t>& ignored)
{
    if (ignored.empty()) return;
    std::string list;
    for (const auto& [kind, n] : ignored)
        list += (list.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
    drawing.notes.push_back("These were ignored because they are not outlines: " + list + ".");
}

} // namespace app
