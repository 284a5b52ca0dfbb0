#pragma once
/// The wall of a study as a black box: random values in, responses out.

#include "app/input/study.hpp"
#include "app/sampling/sample_plan.hpp"
#include "uq/reliability/black_box.hpp"
#include "uq/reliability/limit_state.hpp"

namespace app {

/// Columns of the answer, in SI: those of kWallResponses. Where the force never falls to the ultimate share
/// of the peak, the ultimate displacement is the end of the push: a bound, good for demands below it.
/// @param level index in study.load.vertical_stress
/// @param threads >= 1
[[nodiscard]] uq::BlackBox wall_model(const Study& study, const SamplePlan& plan, int level,
                                      int threads);

/// Standard normal coordinates to the values of a wall.
/// @throws ConfigError with Spatial::stratified, whose draws have no coordinates
[[nodiscard]] uq::Map wall_map(const Study& study, const SamplePlan& plan);

} // namespace app
