#pragma once
/// One block as the wall's model orders it: size, stone, contact faces, support, and how finely it
/// is resolved.

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
    clamped_bottom,            ///< bottom face fixed
    clamped_bottom_held_right, ///< and no horizontal displacement of the right side
    held_right_corner,         ///< no horizontal displacement of the lower right corner
    driven ///< the beam: horizontal displacement of its load line is prescribed
};

struct BlockSpec {
    double width = 0.0, height = 0.0, thickness = 0.0; ///< [m]
    Elastic material;
    std::vector<BlockEdge> edges;
    Motion motion = Motion::free;
    double load_height = 0.0;    ///< driven: of the load line above the block's bottom [m]
    bool rotation_fixed = false; ///< driven
    FaceRule face_rule = FaceRule::even;
    int zones_per_interval = 1;
    double zone_size = 0.0; ///< along sides without contacts [m]
    int modes = 0;          ///< kept; 0: all
};

} // namespace dem
