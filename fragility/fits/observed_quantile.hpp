#pragma once
/// Quantiles of limit displacements without a law, with intervals that suppose none either:
/// what the walls say where no law describes them.

#include "core/interval.hpp"
#include "fragility/fits/observation.hpp"

#include <optional>
#include <span>
#include <vector>

namespace fragility {

struct ObservedQuantile {
    std::optional<double>
        value; ///< smallest value at which the Kaplan-Meier share reaches p; nothing: too
               ///< few walls reached the limit state
    core::Interval interval; ///< 0 below and infinity above where the walls give no bound
};

/// One per share. The interval turns the beta product band of the share round, as moments give
/// it (Fay, Brittain and Proschan 2013, Biostatistics 14, 723-736): without censoring it is
/// that of Clopper and Pearson, so that an interval of ranks results.
/// @param shares in (0, 1)
/// @throws std::invalid_argument for left- and interval-censored data, values that are not
/// numbers,
/// weights other than 1, shares or a confidence not in (0, 1)
[[nodiscard]] std::vector<ObservedQuantile>
observed_quantiles(std::span<const Observation> data, std::span<const double> shares,
                   double confidence = 0.95);

struct ObservedShare {
    double share; ///< of walls at or below a value [-]
    core::Interval band;
};
/// The share at each value with its beta product band [-]. Beyond the last wall the share is
/// not known: the band goes up to 1 there.
/// @param values ascending
/// @throws as observed_quantiles
[[nodiscard]] std::vector<ObservedShare> observed_shares(std::span<const Observation> data,
                                                         std::span<const double> values,
                                                         double confidence = 0.95);

} // namespace fragility
