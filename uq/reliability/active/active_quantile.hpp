#pragma once
/// A low quantile of a response from few evaluations: a Gaussian process learns where the
/// response is near it, and true evaluations check the process.

#include "uq/reliability/active/active_learning.hpp"

namespace uq {

struct ActiveQuantileOptions {
    double probability = 0.05; ///< that the response is at or below the quantile, (0, 1/2]
    /// Evaluations, and the target: coefficient of variation of the probability at the
    /// quantile.
    ActiveOptions active{};
    /// Answers from here on are censored: the response is known to be that large or larger.
    double known_below = std::numeric_limits<double>::infinity();
};

struct ActiveQuantileResult {
    double value = 0.0; ///< not a number: beyond what is known
    /// Interval of the quantile; its upper end is infinite where that lies among censored
    /// answers, its lower end minus infinite where failed ones may hide it.
    core::Interval interval{};
    SamplingOutcome outcome = SamplingOutcome::no_answer;
    std::size_t learned = 0, checks = 0, surprises = 0; ///< as in ActiveResult
    double surrogate = 0.0; ///< quantile by the last process alone, not checked
    std::string trouble;    ///< why the process could not be made; empty if it could
    Ledger ledger;
};

/// Rounds as in active_learning, with the event that the response is at or below the quantile
/// of the process of that round. A check u_i gives, for every t and without bias,
///
///   Y_i(t) = P_i(t) + (phi / q)(u_i) (I(y(u_i) <= t) - passing_i(u_i, t)),
///
/// so that the mean of all checks is the distribution function near the quantile. Its crossing
/// of the probability is the answer, and the interval goes on both sides as far as the interval
/// of P(y <= t) holds the probability (Woodruff 1952). A round learns where the last one's
/// quantile has, by the new process, another probability by half, or where it saves more checks
/// than it costs. Failed evaluations are below every t at the lower end and above at the upper
/// end.
/// @param s its threshold is not used; passing must be at_or_below
/// @throws std::invalid_argument naming the option that is out of range
[[nodiscard]] ActiveQuantileResult active_quantile(const LimitState& s,
                                                   const ActiveQuantileOptions& o = {});

} // namespace uq
