#pragma once
/// The event whose probability is sought, ready for the methods of uq/.

#include "app/input/command.hpp"
#include "app/input/study.hpp"
#include "uq/reliability/reliability.hpp"

namespace app {

/// From a study of walls: one level, the study's only one or --level.
/// @throws ConfigError
[[nodiscard]] uq::ReliabilityProblem wall_problem(const Study& study, const Command& command);

/// From a study of another program (docs/external_program.md).
/// @throws ConfigError
[[nodiscard]] uq::ReliabilityProblem program_event(const Study& study, int threads);

/// What the study asks for in both cases, still without its event: dimension, method, budget and seed.
/// @throws ConfigError if the budget is too small for the method, or the method cannot have correlated inputs
[[nodiscard]] uq::ReliabilityProblem asked_problem(const Study& study, Eigen::Index dimension);

} // namespace app
