#pragma once
/// The standard normal distribution. Quantiles by algorithm AS 241, PPND16 (Wichura 1988,
/// Applied Statistics 37, 477-484): within 1e-15 of the value, relative, for probabilities from
/// 1e-300 to 1 - 1e-16; finite from the smallest double to the largest below 1. Tails by erfc.

#include <span>

namespace core {

[[nodiscard]] double normal_density(double z);
[[nodiscard]] double normal_cdf(double z);      ///< P(Z < z)
[[nodiscard]] double normal_survival(double z); ///< P(Z > z)

/// x with Phi(x) = p. Exactly -normal_quantile(1 - p) where 1 - p is exact.
/// @param p in (0, 1), else std::invalid_argument
[[nodiscard]] double normal_quantile(double p);

/// x with 1 - Phi(x) = q: for an upper tail smaller than what 1 - q resolves.
/// @param q in (0, 1), else std::invalid_argument
[[nodiscard]] double upper_normal_quantile(double q);

/// normal_quantile() of every entry, in place; the same bits, several times faster.
/// @throws std::invalid_argument as normal_quantile; entries may have changed
void to_normal_quantiles(std::span<double> p);

} // namespace core
