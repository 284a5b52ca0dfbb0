#pragma once
/// Observations made ready for fitting: on the axis of the law (ln x for laws of positive
/// values), standardised, equal ones merged.

#include "fragility/fits/observation.hpp"
#include "fragility/laws/law.hpp"

#include <Eigen/Dense>

#include <cstddef>
#include <span>
#include <vector>

namespace fragility {

/// Entries in the order observed, right-, left-, interval-censored; `lower` holds the value of
/// the first three. On the axis y = (axis(x) - shift) / scale.
struct CensoredSample {
    Law law = Law::lognormal;
    std::vector<double> lower, upper, weight;
    std::size_t observed = 0, right = 0, left = 0, interval = 0; ///< numbers of entries
    std::vector<std::size_t> entry; ///< of each observation: a bootstrap weighs entries anew
    double shift = 0.0, scale = 1.0;
};

/// @throws nothing; the observations must have passed screen() (censored_fit.hpp)
[[nodiscard]] CensoredSample prepare(Law law, std::span<const Observation> data);

/// Working parameters: (location, ln dispersion) on the axis of x.
using Working = Eigen::Vector2d;
[[nodiscard]] Working working(const Distribution& d);
[[nodiscard]] Distribution distribution(Law law, const Working& theta);

/// Log-likelihood and derivatives for the working parameters, of densities of x.
struct Likelihood {
    double value;
    Eigen::Vector2d gradient;
    Eigen::Matrix2d hessian;
};
[[nodiscard]] Likelihood log_likelihood(const CensoredSample& sample, const Working& theta);

} // namespace fragility
