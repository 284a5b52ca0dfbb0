#pragma once
/// The methods of uq/ applied to a problem, and what they found in one form.

#include "app/reliability/event.hpp"

#include <Eigen/Core>

#include <functional>
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
    std::optional<double> std_error;
    std::optional<double> lower, upper; ///< 95 % interval
};

/// What the response depends on, by one measure.
struct Sensitivity {
    std::string measure;            ///< "partial rank correlation with the response"
    std::vector<InputShare> shares; ///< in the order of the inputs
};

/// A point of the limit state nearest to the origin, of all that were found.
struct DesignPointFound {
    double beta = 0.0;
    Eigen::VectorXd u; ///< standard normal coordinates
    Eigen::VectorXd x; ///< inputs in their units
};

struct ReliabilityAnswer {
    std::vector<MethodAnswer> methods;
    std::vector<Sensitivity> sensitivities;
    std::vector<DesignPointFound> points; ///< nearest first
    std::vector<std::string> warnings;
    std::size_t evaluations = 0;
    std::vector<uq::FailedSample> failed;
};

/// One evaluated sample of the expensive model.
struct Evaluated {
    Eigen::VectorXd x;
    double response = 0.0; ///< not a number if it failed
    std::string failure;
};

/// Why a budget does not suffice for a method; empty if it does.
/// @param dimension of the event's coordinates
[[nodiscard]] std::string too_small(ReliabilityMethod method, int budget,
                                    Eigen::Index dimension);

/// @param seen every evaluation of the expensive model in order; complete also where this throws
/// @param on_batch called after every batch of evaluations
[[nodiscard]] ReliabilityAnswer answer(const ReliabilityProblem& problem,
                                       std::vector<Evaluated>& seen,
                                       const std::function<void()>& on_batch = {});

} // namespace app
