#pragma once
/// A wall drawn or photographed by somebody else, as polygons that fit together: blocks that
/// touch share their corners bit by bit, so that a common face is a side of both.
/// docs/drawings.md says what is read and refused.

#include "dem/scene/geometry/snapshot.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace app {

/// One block. The lower left corner of all blocks together is (0, 0), z points upwards.
struct DrawnBlock {
    /// Counter-clockwise and simple [m]. No corner is within `snap` of the straight line of its
    /// neighbours, unless another block has a corner there. A common face has the same two
    /// corners in both blocks.
    std::vector<dem::Point> outline;
    std::string layer; ///< UTF-8; empty where the format has none
};

struct Drawing {
    std::vector<DrawnBlock> blocks; ///< in the order of the file
    std::vector<std::string>
        notes; ///< what was closed, simplified, ignored: full sentences with counts
};

struct DrawingOptions {
    double unit = 1.0; ///< length of one unit of the drawing [m], > 0; of DXF, JSON, SVG
    /// Whether that is what the user says; otherwise the unit that the file states goes before
    /// it.
    bool unit_given = true;
    double snap =
        5e-4; ///< gaps and overlaps up to this are closed [m], in [0, 0.1]; of DXF, JSON, SVG
    /// Open outlines of four corners or more are closed by a straight side; of DXF, SVG.
    bool close_outlines = false;
    double width = 0.0;     ///< of a picture [m], > 0; of PNG
    double height = 0.0;    ///< of a picture [m], > 0; of PNG
    double simplify = 5e-3; ///< tolerance of outlines traced from a picture [m], >= 0; of PNG
};

/// Whether a file is read as a picture of stones.
[[nodiscard]] bool is_picture(const std::filesystem::path& path);

/// Whether the outlines of a file may be open: polylines of DXF and SVG.
[[nodiscard]] bool has_polylines(const std::filesystem::path& path);

/// The outlines of a study, as they fit together within 2 um: where they do to 0.1 um they stay
/// as they are. Refuses blocks that cross themselves, overlap, hide in each other or touch
/// nothing, as a drawing is refused.
/// @param file named in the message
/// @param line of the file, from 1; 0: none
/// @throws ConfigError
[[nodiscard]] Drawing fit_blocks(const std::string& file, int line,
                                 std::span<const DrawnBlock> blocks);

/// Reads the format that the file's extension names: .dxf, .json, .svg or .png. The same file
/// and options give the same bits. Cost: n log n in the number of corners.
/// @throws ConfigError `file:line: what is wrong and what to write`, with coordinates in the
/// unit of the drawing
[[nodiscard]] Drawing read_drawing(const std::filesystem::path& path,
                                   const DrawingOptions& options);

} // namespace app
