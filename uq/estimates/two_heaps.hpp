#pragma once
/// Whether values lie in more than one heap: Silverman's (1981) test of one mode.

#include <cstdint>
#include <span>

namespace uq {

/// Probability that values of one heap need as wide a kernel as these to show one mode: small
/// values speak for two heaps or more. Bootstrap of samples smoothed at that width and shrunk
/// to the variance of the values; known to be conservative.
/// @param values finite, at least 5 and not all equal, else std::invalid_argument
/// @param resamples >= 19
[[nodiscard]] double one_heap_p_value(std::span<const double> values, int resamples = 199,
                                      std::uint64_t seed = 1);

} // namespace uq
