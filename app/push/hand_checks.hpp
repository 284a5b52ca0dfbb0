#pragma once
/// Closed forms that an engineer checks a push by: equilibrium of the wall as a rigid body,
/// Coulomb friction, and the largest compression at the base.

#include "app/study/pushed/pushed_wall.hpp"
#include "dem/scene/layout.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

struct Study;

struct HandChecks {
    double vertical_load = 0.0; ///< on the top, with the weight of the beam [N]
    double wall_weight = 0.0;   ///< of what can turn [N]
    /// As dem::RigidWall has it [N]; nothing for a wall that is drawn, has openings, or whose
    /// joints have mortar.
    std::optional<double> rocking_limit;
    /// The same; nothing where the angle is drawn for each joint or wall, nor where there is no
    /// rocking limit.
    std::optional<double> sliding_limit;
    /// dem::toe_stress at the end of the push [Pa]; nothing where the push failed. Where joints
    /// have no compressive strength, nothing limits it.
    std::optional<double> toe_stress;
    std::vector<std::string>
        remarks; ///< results beyond a limit, and what cannot happen in this wall
};

/// Limits of small displacements; units that crack, cohesion and the flexibility of the wall
/// lower them.
[[nodiscard]] HandChecks hand_checks(const Study& study, const dem::Layout& layout,
                                     const PushedWall& wall);

} // namespace app
