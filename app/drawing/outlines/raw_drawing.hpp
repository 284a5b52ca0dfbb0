#pragma once
/// Content of a drawing before its outlines are fitted together, in its own unit, and how it is
/// refused.

#include "app/text/words.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace app {

constexpr std::size_t kMostBlocks = 20'000;
constexpr std::size_t kMostCorners = 1'000'000;

struct LengthUnit {
    std::string_view name;
    double metres = 0.0;
    int dxf_code =
        0; ///< of the header variable $INSUNITS (DXF reference of Autodesk, HEADER section)
};
/// The units that drawings are made in.
constexpr std::array<LengthUnit, 5> kLengthUnits = {
    {{"mm", 1e-3, 4}, {"cm", 1e-2, 5}, {"m", 1.0, 6}, {"in", 0.0254, 1}, {"ft", 0.3048, 2}}};

/// A polygon, closed by the side from its last corner to its first.
struct RawOutline {
    std::vector<dem::Point> corners; ///< in the drawing's unit, z upwards
    std::string layer;
    int line = 0; ///< of the file, from 1
};

/// A straight line that is a side of one or two blocks.
struct RawLine {
    dem::Point from, to; ///< in the drawing's unit, z upwards
    std::string layer;
    int line = 0; ///< of the file, from 1
};

/// Names the file and writes its coordinates.
struct DrawingFrame {
    std::string file;
    double unit = 1.0;           ///< length of one unit of the drawing [m]
    bool z_down = false;         ///< the second coordinate of the file points downwards
    dem::Point origin;           ///< what became (0, 0), in the drawing's unit, z upwards
    bool unit_given = true;      ///< the user gives the unit, whatever the file states
    bool snap_given = true;      ///< there is a wall.snap that the user can change
    bool close_outlines = false; ///< open outlines of four corners or more
    std::string part;            ///< of the file that is read, named at the end of refusals
};

/// Outlines that do not end where they begin, and were read all the same.
struct MendedOutlines {
    std::size_t run_on = 0; ///< over their own first sides
    int first_run_on = 0;   ///< line of the file
    std::size_t closed = 0; ///< by a straight side
    double widest = 0.0;    ///< gap that was closed [m]
    int widest_line = 0;    ///< of the file
};

struct RawDrawing {
    DrawingFrame frame;
    std::vector<RawOutline> outlines;
    std::vector<RawLine> lines;
    MendedOutlines mended;
    std::vector<std::string> notes;
    double own_unit =
        0.0; ///< length of one unit [m] that the file itself states; 0 if it states none
    std::string own_unit_name; ///< such as "mm"; empty if the file states none
};

/// Keeps the unit that the file states, and takes it where the user gives none.
/// @param unit [m]
/// @param name such as "mm"; may be empty
void state_unit(RawDrawing& drawing, double unit, std::string_view name);

/// @throws ConfigError always: "file:line: why"
[[noreturn]] void refuse(const DrawingFrame& frame, int line, std::string_view why);

/// "(12.5, 3)" of a point in the drawing's unit, z upwards, as the file has it.
[[nodiscard]] std::string raw_coordinates(const DrawingFrame& frame, dem::Point at);

/// The same of a point in metres from the origin.
[[nodiscard]] std::string coordinates(const DrawingFrame& frame, dem::Point at);

/// "0.4 mm" of a length in metres.
[[nodiscard]] std::string millimetres(double length);

/// Adds a chain of corners that is a closed outline: `closed`, or its ends coincide within
/// `snap`, or it runs on over its own first sides once it is back at its first corner. An open
/// one of four corners or more is closed if the frame says so; one of two is a line.
/// @param snap [m]
/// @throws ConfigError if it is open, or a coordinate is no finite number
void add_outline(RawDrawing& drawing, RawOutline outline, bool closed, double snap);

/// Adds a line.
/// @throws ConfigError if there are too many
void add_line(RawDrawing& drawing, RawLine line);

/// Notes which outlines were mended.
void note_mended(RawDrawing& drawing);

/// Notes how many of each kind were passed over.
void note_ignored(RawDrawing& drawing, const std::map<std::string, std::size_t>& ignored);

/// A point whose coordinates are finite and at most 1e9.
/// @throws ConfigError
[[nodiscard]] dem::Point checked_point(const DrawingFrame& frame, int line, double x, double z);

} // namespace app
