#pragma once
/// The force that a wall owes to its few contact points.
///
/// Points of contact sum up the pressure under a block that rocks. Joints that press along all
/// of a face would put its resultant elsewhere: under a corner, mostly farther inwards.

#include "dem/scene/geometry/snapshot.hpp"

namespace dem {

/// Force by which the contact points make the horizontal load too high, or too low where it is
/// negative [N]. The estimate is of first order: each face that is partly open keeps its gap,
/// straight between its points, and its thrust; its resultant moves to where a spring without
/// tension along the face would have it; and this couple does work on the rotation of the face
/// per displacement of the load, both since the undeformed wall. Faces that hold tension or are
/// crushed count as exact. Zero where the load has not moved.
[[nodiscard]] double points_excess(const Snapshot& wall);

} // namespace dem
