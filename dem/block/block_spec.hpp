#pragma once
/// The specification of one block: size, stone, contact faces, support, and how finely it is
/// resolved.

#include "dem/block/face_rule.hpp"
#include "dem/scene/layout.hpp"

#include <vector>

namespace dem {

/// A contact face on a block's boundary, in the block's own frame (origin at its lower left
/// corner).
struct BlockEdge {
    Point from, to; ///< [m]
    FacePoints points;
    double kn = 0.0; ///< reference stiffness of the contacts [Pa/m], > 0
    double ks = 0.0; ///< [Pa/m], > 0
};

struct BlockSpec {
    double width = 0.0, height = 0.0, thickness = 0.0; ///< extent [m]
    std::vector<Point> outline; ///< counter-clockwise [m]; empty: a rectangle
    Elastic material;
    std::vector<BlockEdge> edges;
    Motion motion = Motion::free;
    double load_height =
        0.0; ///< of the load line above the block's bottom [m]; of a driven block
    bool rotation_fixed = false; ///< of a driven block
    FaceRule face_rule = FaceRule::even;
    int zones_per_interval = 1;
    double zone_size = 0.0; ///< along sides without contacts [m]
    int modes = 0;          ///< number of modes kept; 0 keeps all
    bool begins_with_bending =
        false; ///< pure bending follows the constant strains (block_modes)

    /// Size of the triangles inside an outline, whose strains vary [m].
    [[nodiscard]] double size_inside() const { return 2.0 * zone_size; }
};

} // namespace dem
