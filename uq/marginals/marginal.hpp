#pragma once
/// Distributions of one variable. A distribution is a value; what it can do are free functions
/// with the same names for all.

#include "uq/marginals/shapes/shape.hpp"

#include <limits>
#include <vector>

namespace uq {

/// A shape, cut off outside [lower, upper] and scaled up to one.
struct Marginal {
    Shape shape;
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
};

/// @throws std::invalid_argument naming the parameter that is out of range, or a cut that
/// leaves nothing. Every function below is for marginals that pass.
void check(const Marginal& m);

/// Probability of a continuous shape within the cut; of a discrete shape 1 where a value lies
/// within it, else 0.
[[nodiscard]] double share_left(const Marginal& m);

/// @throws std::invalid_argument for x = nan, p or q outside (0, 1), and from pdf for a
/// variable
/// of separate values: it has no density.
[[nodiscard]] double pdf(const Marginal& m, double x);
[[nodiscard]] double cdf(const Marginal& m, double x);
[[nodiscard]] double complement(const Marginal& m, double x); ///< P(X > x), accurate when small
/// x with cdf(x) = p, p in (0, 1); and with complement(x) = q, accurate for q down to 1e-300.
[[nodiscard]] double quantile(const Marginal& m, double p);
[[nodiscard]] double upper_quantile(const Marginal& m, double q);
[[nodiscard]] double mean(const Marginal& m);
[[nodiscard]] double sd(const Marginal& m);

/// The same probability on the standard normal axis, from whichever tail is the smaller:
///   cdf(x) = Phi(z).
/// For separate values to_normal gives the middle of the step. Except where the map is a line
/// or an exponential, |z| > 37.5 is taken as 37.5, beyond which double has no probabilities.
[[nodiscard]] double from_normal(const Marginal& m, double z);
[[nodiscard]] double to_normal(const Marginal& m, double x);

/// z where from_normal has a kink.
[[nodiscard]] std::vector<double> kinks(const Marginal& m);

} // namespace uq
