#pragma once
/// Places of the joints and cracks of a wall, for random fields over their IDs.

#include "dem/scene/layout.hpp"
#include "uq/fields/field_site.hpp"

#include <vector>

namespace app {

/// Site i is joint ID i + 1: centre, the unit it lies on (bed joints) or ends (head joints: the
/// left one), the course of that unit.
[[nodiscard]] std::vector<uq::Site> joint_sites(const dem::Layout& layout);

/// Site i is crack ID i + 1.
[[nodiscard]] std::vector<uq::Site> crack_sites(const dem::Layout& layout);

} // namespace app
