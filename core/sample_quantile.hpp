#pragma once
/// Quantiles of a sample, by two of the definitions of Hyndman and Fan (1996, The American
/// Statistician 50, 361-365).

#include <span>

namespace core {

/// Linear between the sorted values (definition 7).
/// @param sorted ascending, at least one value
/// @param p in [0, 1]
[[nodiscard]] double sample_quantile(std::span<const double> sorted, double p);

/// The estimate that is about median unbiased for every law (definition 8).
/// @param sorted, p as above
[[nodiscard]] double unbiased_quantile(std::span<const double> sorted, double p);

} // namespace core
