#pragma once
/// Estimates with their standard error and interval.
///
/// A value that is NaN is a sample that failed. It is left out of the estimate and counted;
/// where its possible values are known, the interval is widened to hold them. Intervals assume
/// independent samples; for Latin hypercubes and sequences they are conservative.

#include "core/binomial.hpp"
#include "core/interval.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace uq {

struct Estimate {
    double value;
    double std_error;       ///< of `value`, same unit
    std::size_t n;          ///< sound samples used
    std::size_t failed = 0; ///< samples asked for that gave no answer
    core::Interval interval{};
};

constexpr double kConfidence = 0.95; ///< where nothing else is asked for [-]

struct SoundValues {
    std::vector<double> values; ///< in the order given
    std::size_t failed;
};
/// @throws std::invalid_argument naming the value that is infinite
[[nodiscard]] SoundValues sound_values(std::span<const double> y);

/// Student's interval. Exact for normal values; for others as good as the mean is normal.
/// @throws std::invalid_argument for fewer than 2 sound values or a confidence outside (0, 1)
[[nodiscard]] Estimate estimate_mean(std::span<const double> y,
                                     double confidence = kConfidence);

/// The mean of answers that are known to lie in [lower, upper]. The interval holds the mean of
/// all samples, whatever the failed ones would have answered.
[[nodiscard]] Estimate estimate_mean(std::span<const double> y, double lower, double upper,
                                     double confidence = kConfidence);

/// Probability of an event seen in `hits` of `n` sound samples. A failed sample could be
/// either: lower limit as if none of them hit, upper as if all did; likewise the standard error
/// is that of the proportion nearest 1/2 that they allow.
/// @throws std::invalid_argument for n = 0, hits > n, or a confidence outside (0, 1)
[[nodiscard]] Estimate
estimate_probability(std::size_t hits, std::size_t n, std::size_t failed = 0,
                     double confidence = kConfidence,
                     core::BinomialInterval kind = core::BinomialInterval::wilson);

/// Share of the samples for which y <= threshold.
[[nodiscard]] Estimate
estimate_probability_below(std::span<const double> y, double threshold,
                           double confidence = kConfidence,
                           core::BinomialInterval kind = core::BinomialInterval::wilson);

} // namespace uq
