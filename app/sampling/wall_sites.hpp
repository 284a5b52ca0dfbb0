#pragma once
/// Where the joints and cracks of a wall are, by their IDs: the one place that says so, for
/// random fields and for people.

#include "dem/scene/layout.hpp"
#include "uq/fields/field_site.hpp"

#include <string_view>
#include <vector>

namespace app {

struct JointPlace {
    dem::FaceKind kind = dem::FaceKind::bed_joint; ///< or head_joint, or unit_crack
    /// Middle, the unit it lies on (bed joints) or ends (head joints: the left one), the course
    /// of that unit. A crack is in its unit.
    uq::Site site;
    double length = 0.0; ///< [m]
};

/// Place i is joint ID i + 1.
[[nodiscard]] std::vector<JointPlace> joint_places(const dem::Layout& layout);

/// Place i is crack ID i + 1.
[[nodiscard]] std::vector<JointPlace> crack_places(const dem::Layout& layout);

/// "bed joint", "head joint", "crack"
[[nodiscard]] std::string_view kind_name(dem::FaceKind kind);

/// Site i is joint ID i + 1.
[[nodiscard]] std::vector<uq::Site> joint_sites(const dem::Layout& layout);

/// Site i is crack ID i + 1.
[[nodiscard]] std::vector<uq::Site> crack_sites(const dem::Layout& layout);

} // namespace app
