#include "app/drawing/raw_drawing.hpp"

#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"

#include <cmath>
#include <utility>

namespace app {

void state_unit(RawDrawing& drawing, double unit, std::string_view name)
{
    drawing.own_unit = unit;
    drawing.own_unit_name = name;
    if (!drawing.frame.unit_given && unit > 0.0) drawing.frame.unit = unit;
}

void refuse(const DrawingFrame& frame, int line, std::string_view why)
{
    throw ConfigError(frame.file, line, "", why);
}

std::string raw_coordinates(const DrawingFrame& frame, dem::Point at)
{
    const double second = frame.z_down ? -at.z : at.z;
    return "(" + number(at.x, 8) + ", " + number(second + 0.0, 8) + ")";
}

std::string coordinates(const DrawingFrame& frame, dem::Point at)
{
    // the conversion to metres and back must not turn 0.3 into 0.30000000000000004, nor 2 into 1.9999999
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

void add_outline(RawDrawing& drawing, RawOutline outline, bool closed, double snap)
{
    const DrawingFrame& frame = drawing.frame;
    std::vector<dem::Point>& corners = outline.corners;
    if (drawing.outlines.size() >= kMostBlocks) {
        refuse(frame, outline.line,
               "has more than " + std::to_string(kMostBlocks) +
                   " blocks; draw a part of the wall");
    }
    if (corners.empty()) refuse(frame, outline.line, "an outline has no corners; delete it");
    const dem::Point first = corners.front(), last = corners.back();
    const double gap = std::hypot(last.x - first.x, last.z - first.z) * frame.unit;
    if (!closed && (gap > snap || corners.size() < 3)) {
        refuse(frame, outline.line,
               "this outline is open: it begins at " + raw_coordinates(frame, first) +
                   " and ends at " + raw_coordinates(frame, last) + ", " + millimetres(gap) +
                   " apart; close it, or delete it if it is not a block");
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

void note_ignored(RawDrawing& drawing, const std::map<std::string, std::size_t>& ignored)
{
    if (ignored.empty()) return;
    std::string list;
    for (const auto& [kind, n] : ignored)
        list += (list.empty() ? "" : ", ") + std::to_string(n) + " " + kind;
    drawing.notes.push_back("These were ignored because they are not outlines: " + list + ".");
}

} // namespace app
