#pragma once
/// Refits to resampled data: what a fit would have been with other walls.

#include "fragility/censored_fit.hpp"
#include "fragility/fit_intervals.hpp"
#include "fragility/random_bits.hpp"

#include <span>
#include <string>
#include <vector>

namespace fragility {

enum class Resampling {
    walls, ///< whole observations, drawn with replacement (nonparametric)
    law    ///< from the fitted law, stopped as the walls were (parametric)
};

struct BootstrapOptions {
    std::size_t replicates = 2000;
    Resampling resampling = Resampling::walls;
};

/// Refits in the order of their replicates. Resamples that cannot be fitted are left out and
/// counted; an interval then says what the others say.
struct Bootstrap {
    Distribution estimate;          ///< of the data themselves
    std::vector<Distribution> laws; ///< of the resamples
    std::size_t failed = 0;
    std::vector<Distribution> without_one; ///< refits without one observation each (jackknife)
    std::vector<double> without_weight;    ///< of the observation left out
};

/// Resampled from the law, the stopping point of an observed wall is drawn from the Kaplan-Meier
/// estimate of the stopping points beyond it (Davison and Hinkley 1997, algorithm 3.2); with one
/// stopping point for all it is that one.
/// @throws std::invalid_argument if the fit has not converged, a weight is not a whole number,
/// no replicate is asked for, or values drawn from the law are asked for where data are left- or
/// interval-censored (their limits are not known for other walls)
[[nodiscard]] Bootstrap bootstrap(const Fit& fit, std::span<const Observation> data,
                                  const RandomBits& bits, const BootstrapOptions& options = {});

/// @throws std::invalid_argument if fewer than 20 refits succeeded
[[nodiscard]] Interval percentile_interval(const Bootstrap& b, Quantity q,
                                           double confidence = 0.95);
[[nodiscard]] Interval bca_interval(const Bootstrap& b, Quantity q, double confidence = 0.95);

/// Quantile of sorted values, linear between them (definition 7 of Hyndman and Fan 1996).
[[nodiscard]] double sample_quantile(std::span<const double> sorted, double p);

/// Ends of a percentile interval of values in any order.
[[nodiscard]] Interval percentiles(std::vector<double> values, double confidence);

} // namespace fragility
