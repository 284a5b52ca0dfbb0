#pragma once
/// The beta distribution over (0, 1) and Student's, by Boost.Math. One file has them for all,
/// because a compiler takes seconds for each file that does.

namespace core {

/// P(X <= x) for X of Beta(a, b). @param x in [0, 1]
[[nodiscard]] double beta_probability(double a, double b, double x);

/// x with P(X <= x) = p. @param p in (0, 1)
[[nodiscard]] double beta_quantile(double a, double b, double p);

/// x with P(X > x) = q. @param q in (0, 1)
[[nodiscard]] double upper_beta_quantile(double a, double b, double q);

/// x with P(T > x) = q. @param q in (0, 1)
[[nodiscard]] double upper_student_quantile(double freedom, double q);

} // namespace core
