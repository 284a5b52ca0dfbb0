#pragma once
/// Small probabilities from few evaluations: a Gaussian process learns where the event begins,
/// and true evaluations check it, so that the answer has no bias if the process is wrong.

#include "uq/reliability/limit_state/exceedance.hpp"

#include <optional>

namespace uq {

struct ActiveOptions {
    std::size_t max_evaluations = 1000; ///< at least least_active_budget()
    double target_cov = 0.1;  ///< of the probability [-], > 0; learning and checking stop there
    double confidence = 0.95; ///< of the interval, (0, 1)
    std::uint64_t seed = 1;
};

/// Evaluations asked for at a time: registers of walls are full, whatever their width.
constexpr Eigen::Index kActiveBatch = 8;

/// First points, by which the process starts: a multiple of the batch.
[[nodiscard]] Eigen::Index first_points(Eigen::Index dimension);

/// First points and two batches each of learning and of checks.
[[nodiscard]] std::size_t least_active_budget(Eigen::Index dimension);

struct ActiveResult {
    Exceedance exceedance;
    std::size_t learned = 0;   ///< evaluations that taught alone, first points among them
    std::size_t checks = 0;    ///< evaluations that judged the process, and taught it later
    std::size_t surprises = 0; ///< checks that fell on the side that it had thought less likely
    double surrogate = 0.0;    ///< probability by the last process alone, not checked
    std::string trouble;       ///< why the process could not be made; empty if it could
};

/// Rounds of kActiveBatch evaluations, each with the process of all evaluations before it. A
/// round learns (next_points) where the probability is another by half than by the process
/// before, and as long as that saves more checks than it costs, as the process sees it, but
/// with at most half of the budget; else it checks: points u_i drawn in the
/// known density q, which favours doubt and the event, give
///
///   Y_i = P_i + (phi / q)(u_i) (I(u_i) - passing_i(u_i)),
///
/// where P_i is the probability by the process of that round. Each Y_i has the mean P, however
/// wrong the process is; the answer is their mean. Its standard error is the larger of what
/// their scatter says and what the process expects, and holds half a wrong answer about the
/// event that the checks may have missed. Failed evaluations teach nothing; as checks they are
/// safe at the lower end of the interval and passed at its upper end.
/// @throws std::invalid_argument naming the option that is out of range
[[nodiscard]] ActiveResult active_learning(const LimitState& s, const ActiveOptions& o = {});

} // namespace uq
