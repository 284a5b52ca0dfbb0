#pragma once
/// How many pieces a pattern of cracks makes of a unit.

#include "dem/scene/crack_pattern.hpp"

#include <vector>

namespace dem {

/// The number of pieces that pieces_of() makes of a convex outline; of others about as many.
/// Costs nothing.
/// @param unit_length of a whole unit [m]; 0: this is one
[[nodiscard]] double piece_count(const std::vector<Point>& outline, const CrackPattern& pattern,
                                 double unit_length);

} // namespace dem
