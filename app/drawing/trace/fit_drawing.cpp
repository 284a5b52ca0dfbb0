#include "app/drawing/outlines/drawing_formats.hpp"

#include "app/drawing/outlines/line_faces.hpp"
#include "app/drawing/outlines/outline_network.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace app {
namespace {

/// In the drawing's unit.
dem::Region extent_of(const RawDrawing& raw)
{
    dem::Region all = dem::extent_of(raw.outlines.front().corners);
    for (const RawOutline& outline : raw.outlines)
        all = dem::join(all, dem::extent_of(outline.corners));
    return all;
}

/// The units that make walls of a usual size.
std::string units_that_fit(double size)
{
    std::string names;
    for (const LengthUnit& unit : kLengthUnits) {
        const double metres = size * unit.metres;
        if (metres < 0.3 || metres > 50.0) continue;
        names += (names.empty() ? "" : " or ") + std::string(unit.name);
    }
    return names;
}

void check_size(const RawDrawing& raw, const dem::Region& e)
{
    constexpr double kSmallest = 0.05, kLargest = 100.0; // [m]
    const double width = e.x1 - e.x0, height = e.z1 - e.z0, size = std::max(width, height);
    const double unit = raw.frame.unit;
    if (size * unit >= kSmallest && size * unit <= kLargest) return;
    const std::string fits = units_that_fit(size);
    refuse(raw.frame, 0,
           "the wall is " + number(width * unit, 4) + " x " + number(height * unit, 4) +
               " m, from " + raw_coordinates(raw.frame, {e.x0, e.z0}) + " to " +
               raw_coordinates(raw.frame, {e.x1, e.z1}) + "; walls have 0.05 to 100 m: " +
               (fits.empty() ? "draw it in its true size"
                             : "wall.length_unit = " + fits + " would fit") +
               (raw.own_unit_name.empty()
                    ? ""
                    : "; the file says that its unit is " + raw.own_unit_name));
}

void note_unit(RawDrawing& raw, const dem::Region& e)
{
    const double unit = raw.frame.unit;
    if (raw.own_unit <= 0.0) {
        if (raw.frame.unit_given) return;
        raw.notes.push_back("The file states no unit of length; one unit was read as " +
                            millimetres(unit) + ", and the wall is " +
                            number((e.x1 - e.x0) * unit, 4) + " x " +
                            number((e.z1 - e.z0) * unit, 4) +
                            " m. Set wall.length_unit if that is not its size.");
        return;
    }
    const std::string says =
        "The file says that its unit is " +
        (raw.own_unit_name.empty() ? number(raw.own_unit * 1e3, 6) + " mm" : raw.own_unit_name);
    if (!raw.frame.unit_given) {
        raw.notes.push_back(says + "; the wall is " + number((e.x1 - e.x0) * unit, 4) + " x " +
                            number((e.z1 - e.z0) * unit, 4) +
                            " m. Set wall.length_unit to override.");
    } else if (std::abs(raw.own_unit / unit - 1.0) >= 1e-3) {
        raw.notes.push_back(says + "; it was read with a unit of " + number(unit * 1e3, 6) +
                            " mm (wall.length_unit).");
    }
}

OutlineNetwork network_of(RawDrawing raw, double snap)
{
    OutlineNetwork network;
    network.frame = raw.frame;
    network.snap = std::max(snap, kLeastSnap);
    network.notes = std::move(raw.notes);
    for (RawOutline& outline : raw.outlines) {
        Ring ring{{}, std::move(outline.layer), outline.line};
        for (const dem::Point& p : outline.corners) {
            ring.corners.push_back(static_cast<int>(network.nodes.size()));
            network.nodes.push_back({(p.x - raw.frame.origin.x) * raw.frame.unit,
                                     (p.z - raw.frame.origin.z) * raw.frame.unit});
        }
        network.rings.push_back(std::move(ring));
    }
    return network;
}

/// The farthest that a corner of one outline lies from the sides of another [m].
double farthest_off(std::span<const dem::Point> corners, std::span<const dem::Point> outline)
{
    double farthest = 0.0;
    for (const dem::Point p : corners) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < outline.size(); ++i)
            nearest = std::min(nearest, dem::distance_to_segment(
                                            p, outline[i], outline[(i + 1) % outline.size()]));
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

/// Whether the outlines as they fit together differ from those that were drawn.
bool is_moved(const OutlineNetwork& drawn, const OutlineNetwork& fitted)
{
    for (std::size_t r = 0; r < drawn.rings.size(); ++r) {
        const std::vector<dem::Point> a = outline_of(drawn, drawn.rings[r]),
                                      b = outline_of(fitted, fitted.rings[r]);
        if (farthest_off(a, b) > kLeastSnap || farthest_off(b, a) > kLeastSnap) return true;
    }
    return false;
}

/// Outlines stay where they were written, and the floor at z = 0.
void shift_back(dem::Point origin, Drawing& drawing)
{
    if (std::abs(origin.z) < 2.0 * dem::kTouching) origin.z = 0.0;
    for (DrawnBlock& block : drawing.blocks)
        for (dem::Point& p : block.outline) p = {p.x + origin.x, p.z + origin.z};
}

/// The leftmost corner may have been moved: back to x = 0. The floor is where it was.
void shift_to_origin(Drawing& drawing)
{
    double left = std::numeric_limits<double>::infinity();
    for (const DrawnBlock& block : drawing.blocks)
        left = std::min(left, dem::extent_of(block.outline).x0);
    for (DrawnBlock& block : drawing.blocks)
        for (dem::Point& p : block.outline) p.x -= left;
}

} // namespace

Drawing fit_drawing(RawDrawing raw, double snap)
{
    note_mended(raw);
    add_line_faces(raw, std::max(snap, kLeastSnap));
    if (raw.outlines.empty()) {
        std::string why = "holds no closed outline; draw each block as a closed polyline";
        for (const std::string& note : raw.notes) why += ". " + note;
        refuse(raw.frame, 0, why);
    }
    std::size_t corners = 0;
    for (const RawOutline& outline : raw.outlines) corners += outline.corners.size();
    if (corners > kMostCorners) {
        refuse(raw.frame, 0,
               "has more than " + std::to_string(kMostCorners) +
                   " corners; simplify the drawing");
    }
    const dem::Region extent = extent_of(raw);
    check_size(raw, extent);
    note_unit(raw, extent);
    raw.frame.origin = {extent.x0, extent.z0};
    Drawing drawing;
    if (!raw.frame.snap_given)
        for (const RawOutline& o : raw.outlines) drawing.blocks.push_back({o.corners, o.layer});
    OutlineNetwork network = network_of(std::move(raw), snap);
    const OutlineNetwork drawn = network;
    fit_corners(network);
    check_outlines(network);
    const bool as_written = !network.frame.snap_given && !is_moved(drawn, network);
    if (as_written) {
        network.notes = drawn.notes;
    } else {
        drawing.blocks.clear();
        for (const Ring& ring : network.rings)
            drawing.blocks.push_back({outline_of(network, ring), ring.layer});
        if (network.frame.snap_given)
            shift_to_origin(drawing);
        else
            shift_back(network.frame.origin, drawing);
    }
    note_gaps(network);
    drawing.notes = std::move(network.notes);
    return drawing;
}

} // namespace app
