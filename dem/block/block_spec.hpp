#pragma once
/// The specification of one block: size, stone, contact faces, support, and how finely it is resolved.

#include "dem/block/face_rule.hpp"
#include "dem/scene/snapshot.hpp"
#include "dem/scene/wall.hpp"

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

/// Support of a block.
enum class Motion {
    free,
    clamped_bottom,            ///< the bottom face is fixed
    clamped_bottom_held_right, ///< in addition, the right side has no horizontal displacement
    held_right_corner,         ///< the lower right corner has no horizontal displacement
    driven ///< the loading beam: the horizontal displacement of its load line is prescribed
};

struct BlockSpec {
    double width = 0.0, height = 0.0, thickness = 0.0; ///< [m]
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
};

} // namespace dem
