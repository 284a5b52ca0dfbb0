#include "app/drawing/fit_drawing.hpp"

#include "app/drawing/line_faces.hpp"
#include "app/drawing/outline_network.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace app {
namespace {

struct Extent {
    dem::Point low, high; ///< in the drawing's unit
};

Extent extent_of(const RawDrawing& raw)
{
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Extent e{{kFar, kFar}, {-kFar, -kFar}};
    for (const RawOutline& outline : raw.outlines)
        for (const dem::Point& p : outline.corners) {
            e.low = {std::min(e.low.x, p.x), std::min(e.low.z, p.z)};
            e.high = {std::max(e.high.x, p.x), std::max(e.high.z, p.z)};
        }
    return e;
}

struct LengthUnit {
    const char* name;
    double length; ///< [m]
};
constexpr std::array kUnits = {LengthUnit{"mm", 1e-3}, LengthUnit{"cm", 1e-2},
                               LengthUnit{"m", 1.0}, LengthUnit{"in", 0.0254},
                               LengthUnit{"ft", 0.3048}};

/// The units that make walls of a usual size.
std::string units_that_fit(double size)
{
    std::string names;
    for (const LengthUnit& unit : kUnits) {
        const double metres = size * unit.length;
        if (metres < 0.3 || metres > 50.0) continue;
        names += (names.empty() ? "" : " or ") + std::string(unit.name);
    }
    return names;
}

void check_size(const RawDrawing& raw, const Extent& e)
{
    constexpr double kSmallest = 0.05, kLargest = 100.0; // [m]
    const double width = e.high.x - e.low.x, height = e.high.z - e.low.z,
                 size = std::max(width, height);
    const double unit = raw.frame.unit;
    if (size * unit >= kSmallest && size * unit <= kLargest) return;
    const std::string fits = units_that_fit(size);
    refuse(raw.frame, 0,
           "the wall is " + number(width * unit, 4) + " x " + number(height * unit, 4) +
               " m, from " + raw_coordinates(raw.frame, {e.low.x, e.low.z}) + " to " +
               raw_coordinates(raw.frame, {e.high.x, e.high.z}) +
               "; walls have 0.05 to 100 m: " +
               (fits.empty() ? "draw it in its true size"
                             : "wall.length_unit = " + fits + " would fit") +
               (raw.own_unit_name.empty()
                    ? ""
                    : "; the file says that its unit is " + raw.own_unit_name));
}

void note_unit(RawDrawing& raw, const Extent& e)
{
    if (raw.own_unit <= 0.0) return;
    const double unit = raw.frame.unit;
    const std::string says =
        "The file says that its unit is " +
        (raw.own_unit_name.empty() ? number(raw.own_unit * 1e3, 6) + " mm" : raw.own_unit_name);
    if (!raw.frame.unit_given) {
        raw.notes.push_back(says + ", and was read so: it is " +
                            number((e.high.x - e.low.x) * unit, 4) + " x " +
                            number((e.high.z - e.low.z) * unit, 4) +
                            " m. wall.length_unit would read it otherwise.");
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

/// The leftmost corner may have been moved: back to x = 0. The floor is where it was.
void shift_to_origin(Drawing& drawing)
{
    double left = std::numeric_limits<double>::infinity();
    for (const DrawnBlock& block : drawing.blocks)
        for (const dem::Point& p : block.outline) left = std::min(left, p.x);
    for (DrawnBlock& block : drawing.blocks)
        for (dem::Point& p : block.outline) p.x -= left;
}

} // namespace

Drawing fit_drawing(RawDrawing raw, double snap)
{
    add_line_faces(raw, std::max(snap, kLeastSnap));
    if (raw.outlines.empty()) {
        refuse(raw.frame, 0, "holds no closed outline; draw each block as a closed polyline");
    }
    std::size_t corners = 0;
    for (const RawOutline& outline : raw.outlines) corners += outline.corners.size();
    if (corners > kMostCorners) {
        refuse(raw.frame, 0,
               "has more than " + std::to_string(kMostCorners) +
                   " corners; simplify the drawing");
    }
    const Extent extent = extent_of(raw);
    check_size(raw, extent);
    note_unit(raw, extent);
    raw.frame.origin = extent.low;
    OutlineNetwork network = network_of(std::move(raw), snap);
    fit_corners(network);
    check_outlines(network);
    note_gaps(network);
    Drawing drawing;
    for (const Ring& ring : network.rings) {
        DrawnBlock block;
        for (const int n : ring.corners)
            block.outline.push_back(network.nodes[static_cast<std::size_t>(n)]);
        block.layer = ring.layer;
        if (ring.line > 0) block.place = "line " + std::to_string(ring.line);
        drawing.blocks.push_back(std::move(block));
    }
    shift_to_origin(drawing);
    drawing.notes = std::move(network.notes);
    return drawing;
}

} // namespace app
