#pragma once
/// The shapes before they are cut: density, both tails and both their inverses, each relative to
/// its own size, so that 1e-300 is a probability like any other. Constant and Empirical have no
/// density; uq/marginals/marginal_steps.hpp has them.

#include "uq/marginals/marginal.hpp"

namespace uq::shape {

/// Ends of the support.
struct Range {
    double lower, upper;
};

// For each shape:
//   support      where the density lives
//   density      at x inside the support
//   lower_tail   P(X <= x),  upper_tail  P(X > x); any x
//   at_lower     x with P(X <= x) = p,  at_upper  x with P(X > x) = q; p, q in (0, 1)

[[nodiscard]] Range support(const Normal&);
[[nodiscard]] double density(const Normal&, double x);
[[nodiscard]] double lower_tail(const Normal&, double x);
[[nodiscard]] double upper_tail(const Normal&, double x);
[[nodiscard]] double at_lower(const Normal&, double p);
[[nodiscard]] double at_upper(const Normal&, double q);

[[nodiscard]] Range support(const Lognormal&);
[[nodiscard]] double density(const Lognormal&, double x);
[[nodiscard]] double lower_tail(const Lognormal&, double x);
[[nodiscard]] double upper_tail(const Lognormal&, double x);
[[nodiscard]] double at_lower(const Lognormal&, double p);
[[nodiscard]] double at_upper(const Lognormal&, double q);

[[nodiscard]] Range support(const Uniform&);
[[nodiscard]] double density(const Uniform&, double x);
[[nodiscard]] double lower_tail(const Uniform&, double x);
[[nodiscard]] double upper_tail(const Uniform&, double x);
[[nodiscard]] double at_lower(const Uniform&, double p);
[[nodiscard]] double at_upper(const Uniform&, double q);

[[nodiscard]] Range support(const Triangular&);
[[nodiscard]] double density(const Triangular&, double x);
[[nodiscard]] double lower_tail(const Triangular&, double x);
[[nodiscard]] double upper_tail(const Triangular&, double x);
[[nodiscard]] double at_lower(const Triangular&, double p);
[[nodiscard]] double at_upper(const Triangular&, double q);

[[nodiscard]] Range support(const Beta&);
[[nodiscard]] double density(const Beta&, double x);
[[nodiscard]] double lower_tail(const Beta&, double x);
[[nodiscard]] double upper_tail(const Beta&, double x);
[[nodiscard]] double at_lower(const Beta&, double p);
[[nodiscard]] double at_upper(const Beta&, double q);

[[nodiscard]] Range support(const Gamma&);
[[nodiscard]] double density(const Gamma&, double x);
[[nodiscard]] double lower_tail(const Gamma&, double x);
[[nodiscard]] double upper_tail(const Gamma&, double x);
[[nodiscard]] double at_lower(const Gamma&, double p);
[[nodiscard]] double at_upper(const Gamma&, double q);

[[nodiscard]] Range support(const Weibull&);
[[nodiscard]] double density(const Weibull&, double x);
[[nodiscard]] double lower_tail(const Weibull&, double x);
[[nodiscard]] double upper_tail(const Weibull&, double x);
[[nodiscard]] double at_lower(const Weibull&, double p);
[[nodiscard]] double at_upper(const Weibull&, double q);

[[nodiscard]] Range support(const Gumbel&);
[[nodiscard]] double density(const Gumbel&, double x);
[[nodiscard]] double lower_tail(const Gumbel&, double x);
[[nodiscard]] double upper_tail(const Gumbel&, double x);
[[nodiscard]] double at_lower(const Gumbel&, double p);
[[nodiscard]] double at_upper(const Gumbel&, double q);

} // namespace uq::shape
