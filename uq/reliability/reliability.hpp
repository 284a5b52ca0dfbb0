#pragma once
/// The probability of an event and what it depends on: one call for every method.

#include "uq/reliability/limit_state/limit_state.hpp"
#include "uq/reliability/reliability_method.hpp"
#include "uq/reliability/simulation/multi_fidelity.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace uq {

struct ReliabilityProblem {
    LimitState event;
    std::string words; ///< the event for people: "peak force <= 40 kN"; no method reads it
    std::vector<std::string> inputs; ///< names of the columns of x, without units
    std::vector<std::string> normal; ///< names of the columns of u, event.dimension of them
    std::vector<CheapModel> cheap;   ///< for multi_fidelity; cost relative to the event's model
    ReliabilityMethod method = ReliabilityMethod::monte_carlo;
    int budget = 1000;       ///< evaluations at most, >= 1 and as budget_too_small() says
    double target_cov = 0.1; ///< of the probability [-], > 0; not used by form, multi_fidelity
    std::uint64_t seed = 1;
    /// Probability of the quantile that is sought in place of that of the event, (0, 1/2], by
    /// active alone; 0: none. The threshold of the event plays no part then.
    double quantile = 0.0;
    /// Responses from here on are censored: known to be that large or larger.
    double known_below = std::numeric_limits<double>::infinity();
    bool rough = false; ///< answers scatter by some tenths of a percent, as those of walls do
};

/// One way to the probability.
struct MethodAnswer {
    std::string method;                ///< "FORM", "SORM, Breitung", "subset simulation"
    std::optional<double> probability; ///< none: no answer
    std::optional<double> quantile;  ///< of the response, where that is sought; none: no answer
    std::optional<double> std_error; ///< of either
    std::optional<double> lower, upper; ///< 95 % interval, failed evaluations either way
    std::string outcome;                ///< in words: "target reached", why there is no answer
};

struct InputShare {
    std::string input;
    double value = 0.0;
    std::optional<double> std_error;
    std::optional<double> lower, upper; ///< 95 % interval
};

/// Dependence of the response on the inputs, by one measure.
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
    std::size_t evaluations = 0; ///< of the event's model
    std::vector<FailedSample> failed;
};

/// One evaluated sample of the event's model.
struct Evaluated {
    Eigen::VectorXd x;     ///< inputs in their units
    double response = 0.0; ///< not a number if it failed
    std::string failure;   ///< why; empty if it did not fail
};

/// Why a budget does not suffice for a method; empty if it does.
/// @param dimension of the event's coordinates
[[nodiscard]] std::string budget_too_small(ReliabilityMethod method, int budget,
                                           Eigen::Index dimension);

/// Samples that are asked for at a time until one of them is sound: where none ever is, who is
/// called after every batch can end the analysis.
inline constexpr std::size_t kUntilSound = 20;

/// Called after every batch with what was evaluated in it, in order. What it throws ends the
/// analysis, but for a std::exception, which would be the failure of the batch.
using OnBatch = std::function<void(std::span<const Evaluated>)>;

/// The probability of the event by the method asked for, and what the response depends on,
/// where the method shows it. A sample that fails stays alone with its fault, which is among
/// the warnings and the failed samples.
/// @throws std::invalid_argument naming what is missing or out of range: of the event, of its
/// names, of the
/// budget, or no cheap model for multi_fidelity; std::runtime_error if too few samples are
/// sound for multi_fidelity
[[nodiscard]] ReliabilityAnswer reliability(const ReliabilityProblem& problem,
                                            const OnBatch& on_batch = {});

} // namespace uq
