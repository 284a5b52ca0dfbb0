#pragma once
/// The event whose probability is sought, ready for the methods of uq/.

#include "app/input/command.hpp"
#include "app/input/study.hpp"
#include "uq/reliability/limit_state.hpp"
#include "uq/reliability/multi_fidelity.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

struct ReliabilityProblem {
    uq::LimitState event;
    std::string words;               ///< "peak force <= 40 kN under 0.5 MPa"
    std::vector<std::string> inputs; ///< names of the columns of x, with unit
    std::vector<std::string> normal; ///< names of the columns of u
    std::vector<uq::CheapModel>
        cheap; ///< for multi_fidelity; cost relative to the event's model
    ReliabilityMethod method = ReliabilityMethod::monte_carlo;
    int budget = 1000;       ///< evaluations at most
    double target_cov = 0.1; ///< of the probability [-]; not used by form, multi_fidelity
    std::uint64_t seed = 1;
    bool rough = false; ///< answers scatter by some tenths of a percent, as those of walls do
};

/// From a study of walls: one level, the study's only one or --level.
/// @throws ConfigError
[[nodiscard]] ReliabilityProblem wall_problem(const Study& study, const Command& command);

/// From a study of another program (docs/external_program.md).
/// @throws ConfigError
[[nodiscard]] ReliabilityProblem program_event(const Study& study, int threads);

} // namespace app
