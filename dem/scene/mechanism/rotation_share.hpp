#pragma once
/// How much of the displacement of a wall comes from blocks that turn.

#include "dem/scene/geometry/snapshot.hpp"

#include <optional>

namespace dem {

/// Rotation of the loading beam x height / displacement [-]; 1 where the wall turns about its
/// toe as one body. Without a beam there is none.
/// @param height of the load line above the floor [m], > 0
[[nodiscard]] std::optional<double> beam_rotation_share(const Snapshot& wall, double height);

/// How rotations are summed: with their signs, or each as if it were to the side of the push.
enum class Turns { with_sign, to_either_side };

/// The rotation of what moves at each level, summed over the height of the load line /
/// displacement [-]: 1 where the wall, its piers or its columns turn, whether the top turns
/// with them or not, and 0 where parts slide past each other. Blocks of one level count by
/// their width and by how far they move, so that what stays behind says nothing. With their
/// signs the rotations of an arch cancel, whose parts turn to both sides; to either side the
/// levels above the load line count as well, as an arch on piers moves above it.
/// @param height of the load line above the floor [m], > 0
[[nodiscard]] double turning_share(const Snapshot& wall, double height,
                                   Turns turns_count = Turns::with_sign);

} // namespace dem
