#pragma once
/// A probability estimated from samples of which some may have failed.

#include "core/interval.hpp"
#include "uq/estimates/estimate.hpp"
#include "uq/reliability/limit_state/limit_state.hpp"

#include <limits>

namespace uq {

enum class SamplingOutcome {
    target_reached, ///< coefficient of variation as asked for
    limit_reached,  ///< evaluations or levels used up first
    none_passed,    ///< no sample passed: only an upper bound is known
    all_passed,     ///< every sample passed: only a lower bound is known
    no_answer       ///< every evaluation failed
};

struct Exceedance {
    /// Value among sound samples; the interval also holds what failed samples may have been:
    /// all safe at its lower end, all passed at its upper end.
    Estimate estimate{};
    double lower = 0.0; ///< value if every failed sample is safe
    double upper = 1.0; ///< value if every failed sample passes
    SamplingOutcome outcome = SamplingOutcome::no_answer;
    std::vector<std::string> warnings;
    Ledger ledger;
};

/// Standard error / value; infinite where the value is zero.
[[nodiscard]] double coefficient_of_variation(const Estimate& e);

/// The estimate from counts of independent samples, with the interval of Clopper and Pearson;
/// the caller fills in the ledger. If all samples failed, the value is 0, its interval [0, 1]
/// and the outcome no_answer.
[[nodiscard]] Exceedance count_exceedance(std::size_t passed, std::size_t failed, std::size_t n,
                                          double confidence);

/// Interval of a positive estimate whose logarithm is about normal, cut at 1.
/// @param freedom degrees of freedom of the standard error, > 0; infinite: it is known
[[nodiscard]] core::Interval
log_interval(double value, double std_error, double confidence,
             double freedom = std::numeric_limits<double>::infinity());

} // namespace uq
