#pragma once
/// Distributions of separate values: a constant, observations. All functions for `v` ascending,
/// each value as likely as the other.

#include <span>

namespace uq::discrete {

[[nodiscard]] double cdf(std::span<const double> v, double x);
[[nodiscard]] double complement(std::span<const double> v, double x);
/// The smallest value with cdf >= p; and with complement <= q.
[[nodiscard]] double quantile(std::span<const double> v, double p);
[[nodiscard]] double upper_quantile(std::span<const double> v, double q);
[[nodiscard]] double mean(std::span<const double> v);
[[nodiscard]] double sd(std::span<const double> v); ///< of the distribution: divided by n
/// Middle of the step at x: the mean of P(X < x) and P(X <= x). Inside (0, 1).
[[nodiscard]] double middle(std::span<const double> v, double x);

} // namespace uq::discrete
