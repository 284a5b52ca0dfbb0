#pragma once
/// The methods of uq/ applied to a problem, and what they found in one form.

#include "app/reliability/event.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace app {

/// One way to the probability.
struct MethodAnswer {
    std::string method;                ///< "FORM", "SORM, Breitung", "subset simulation"
    std::optional<double> probability; ///< none: no answer
    std::optional<double> std_error;
    std::optional<double> lower, upper; ///< 95 % interval, failed evaluations either way
    std::string outcome;                ///< in words: "target reached", why there is no answer
};

struct InputShare {
    std::string input;
    double value = 0.0;
    std::optional<double> lower, upper;
};

struct ReliabilityAnswer {
    std::vector<MethodAnswer> methods;
    std::string share_name;         ///< what the shares are
    std::vector<InputShare> shares; ///< sensitivities, in the order of the inputs
    std::vector<std::string> warnings;
    std::size_t evaluations = 0, cheap_evaluations = 0;
    std::vector<uq::FailedSample> failed;
};

/// One evaluated sample of the expensive model.
struct Evaluated {
    Eigen::VectorXd x;
    double response = 0.0; ///< not a number if it failed
    std::string failure;
};

/// @param seen every evaluation of the expensive model in order
[[nodiscard]] ReliabilityAnswer answer(const ReliabilityProblem& problem,
                                       std::vector<Evaluated>& seen);

} // namespace app
