#pragma once
/// Which units of a wall come near their strength, so that the others need no potential cracks.

#include "dem/scene/geometry/polygon.hpp"

#include <vector>

namespace app {

struct Study;

/// Units that see at least this share of their mean strength in the coarse push may crack. A
/// choice: the strength of one wall in a thousand of the paper's (lognormal, COV 0.30) is 0.39
/// of the mean; the rest is a margin for the coarse push.
constexpr double kNeededShare = 0.25;

/// Boxes that hold the middles of the units that may crack, course by course [m]. They are
/// found by a coarse push with mean values under each stress level, with divided but
/// unbreakable units: tension over the tensile strength, or shear over what cohesion and
/// friction allow, in any crack at any of some tens of displacements. Where no unit may crack:
/// one box with no middle in it.
/// @param study with Study::wall::cracks of all units
/// @throws std::invalid_argument if the coarse push fails
[[nodiscard]] std::vector<dem::Region> needed_cracks(const Study& study);

} // namespace app
