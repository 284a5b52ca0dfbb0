#pragma once
/// Quantiles of a sample.

#include <span>

namespace fragility {

/// Linear between the sorted values (definition 7 of Hyndman and Fan 1996).
/// @param sorted ascending, at least one value
/// @param p in [0, 1]
[[nodiscard]] double sample_quantile(std::span<const double> sorted, double p);

} // namespace fragility
