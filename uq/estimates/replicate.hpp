#pragma once
/// Standard error from independent repetitions of a whole design.
///
/// Samples of a Latin hypercube or a scrambled sequence are not independent: s / sqrt(n) of one
/// design overstates the error of its mean, often many times over. R designs of n / R
/// samples with seeds of their own are independent, and their spread is the error.

#include "uq/estimates/estimate.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace uq {

/// Mean of R estimates of the same quantity, NaN where a replicate failed; standard error s /
/// sqrt(R) and Student's interval with R - 1 degrees of freedom. `n` counts replicates.
/// @throws std::invalid_argument for fewer than 2 sound replicates
[[nodiscard]] Estimate combine_replicates(std::span<const double> estimates,
                                          double confidence = kConfidence);

struct Replicates {
    Estimate estimate;
    std::vector<double> each; ///< one of every replicate, NaN: failed
};

/// Calls `one` with the seeds of replicates 0 .. count - 1 (uq/designs/stream.hpp: 0 is the study
/// itself).
[[nodiscard]] Replicates replicate(std::size_t count, std::uint64_t seed,
                                   const std::function<double(std::uint64_t seed)>& one,
                                   double confidence = kConfidence);

} // namespace uq
