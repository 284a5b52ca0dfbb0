#pragma once
/// Rows of the table of performance limits: drifts at which 5 to 95 % of the walls have reached
/// a limit state.

#include "core/interval.hpp"
#include "fragility/fits/censored_fit.hpp"
#include "fragility/fits/fit_intervals.hpp"
#include "fragility/fits/median_bound.hpp"

#include <array>
#include <span>
#include <string>

namespace fragility {

constexpr std::array<double, 5> kLimitShares{0.05, 0.16, 0.50, 0.84, 0.95};

struct DriftLimit {
    double share; ///< of walls that have reached the limit state [-]
    double drift; ///< [unit of the data]
    core::Interval interval;
};

/// Numbers are 0 unless `fitted`; without a fit only `bound` says something.
struct PerformanceLimits {
    bool fitted = false;
    std::string reason; ///< why there is no fit
    std::array<DriftLimit, 5> drifts{};
    double dispersion = 0.0; ///< from wall to wall, beta [-] (normal law: [unit of the data])
    core::Interval dispersion_interval{};
    double median_error =
        0.0; ///< statistical: standard error of ln median (normal law: median)
    double predictive_dispersion = 0.0; ///< sqrt(beta^2 + se^2): of a further wall
    double censored_share = 0.0;        ///< of all walls [-]
    double n = 0.0;
    MedianBound bound; ///< without a law; of data with a fit too
};

/// Fits the law and reads its quantiles, with intervals by profile likelihood, widened for
/// small samples (fragility/laws/small_sample.hpp).
/// @throws std::invalid_argument for a confidence not in (0, 1)
[[nodiscard]] PerformanceLimits performance_limits(Law law, std::span<const Observation> data,
                                                   double confidence = 0.95);

} // namespace fragility
