#pragma once
/// One wall pushed, and what an engineer reads off it.

#include "app/input/study.hpp"
#include "app/sampling/wall_draw.hpp"
#include "dem/scene/mechanism.hpp"
#include "dem/solver/push.hpp"
#include "fragility/limit_states.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

struct PushedWall {
    double vertical_stress = 0.0; ///< [Pa]
    dem::Loads loads;
    dem::PushResult result;
    dem::Mechanism mechanism;
    dem::FailureMode mode = dem::FailureMode::rocking;
    std::vector<double> displacement; ///< of the curve [m]
    std::vector<double> force;        ///< [N]
    /// Readings of the curve; empty for a push that turns back or whose numbers broke.
    std::optional<fragility::Peak> peak;
    std::optional<double> stiffness; ///< secant at fragility::kSecantShare of the peak [N/m]
    fragility::LimitDisplacement ultimate;
    std::vector<fragility::LimitState> limit_states; ///< of the sets paper, ntc, ec8
    std::string no_reading;                          ///< why there are none
};

/// Evaluates a finished push: peak, stiffness, limit states, mechanism, failure mode.
/// @param level index in study.load.vertical_stress
[[nodiscard]] PushedWall read_wall(const Study& study, int level, dem::PushResult result);

/// A draw that makes no wall: nothing was pushed, and the wall counts as failed.
[[nodiscard]] PushedWall no_wall(const Study& study, int level, const std::string& why);

} // namespace app
