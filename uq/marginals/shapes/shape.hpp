#pragma once
/// The table of distributions of one variable. A new one is a pair of files beside this one,
/// its include and its row in Shape; input files, help and every function of a marginal then
/// know it.
///
/// Functions of a distribution with a density, all of them accurate relative to their own size,
/// so that 1e-300 is a probability like any other:
///   support      ends of the range where the density lives
///   density      at x inside the support
///   lower_tail   P(X <= x), upper_tail P(X > x); any x
///   at_lower     x with P(X <= x) = p, at_upper x with P(X > x) = q; p, q in (0, 1)
///   mean_sd      mean and standard deviation
///   forms        the ways to write it in text
///   kink         only if the density has one: where it is
/// A distribution of separate values has `values_of` instead: its values in ascending order.

#include "uq/marginals/shapes/beta.hpp"
#include "uq/marginals/shapes/constant.hpp"
#include "uq/marginals/shapes/empirical.hpp"
#include "uq/marginals/shapes/gamma.hpp"
#include "uq/marginals/shapes/gumbel.hpp"
#include "uq/marginals/shapes/lognormal.hpp"
#include "uq/marginals/shapes/normal.hpp"
#include "uq/marginals/shapes/triangular.hpp"
#include "uq/marginals/shapes/uniform.hpp"
#include "uq/marginals/shapes/weibull.hpp"

#include <variant>

namespace uq {

using Shape = std::variant<Constant, Normal, Lognormal, Uniform, Triangular, Beta, Gamma,
                           Weibull, Gumbel, Empirical>;

template <class S>
concept Discrete = requires(const S& s)
{
    values_of(s);
};

} // namespace uq
