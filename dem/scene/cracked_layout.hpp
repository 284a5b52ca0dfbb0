#pragma once
/// Units divided into pieces by potential cracks.

#include "dem/scene/crack_pattern.hpp"
#include "dem/scene/layout.hpp"

namespace dem {

/// Divides the units of a scene that are one block each, but for lintels. Joints keep their
/// IDs, so that a joint that falls into several faces is of one material; new crack IDs follow
/// those that the scene has, by pieces from the bottom to the top and from left to right, unit
/// after unit. Where no unit is divided the scene stays as it is.
/// @param unit_length of a whole unit [m]; 0: each unit is one
[[nodiscard]] Layout with_cracks(Layout scene, const UnitCracks& cracks, double unit_length);

} // namespace dem
