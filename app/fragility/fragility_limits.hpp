#pragma once
/// Tables of limit drifts: performance limits, how well the laws fit, the model over all stresses, and
/// the parameters for pelicun.

#include "app/fragility/fragility_data.hpp"
#include "app/output/table.hpp"

#include <string>

namespace app {

/// 5, 16, 50, 84, 95 % drifts per group and limit state; a sentence where nothing can be fitted.
[[nodiscard]] Table performance_table(const DriftData& data);

/// Laws side by side: AIC, BIC; Kolmogorov-Smirnov, Cramer-von Mises, Anderson-Darling with p-values
/// of the law chosen.
[[nodiscard]] Table fit_table(const DriftData& data);

/// Median and dispersion of lognormal limit drifts as functions of the vertical stress, at the levels
/// and half-way between them. Without stresses: no rows.
[[nodiscard]] Table stress_table(const DriftData& data);

/// One component per group, one limit state column group per limit state of one set, in the order of
/// their medians (of the set, where one is missing): ID, Incomplete, Demand-Type, Demand-Unit, Demand-Offset, Demand-Directional,
/// LS1-Family, LS1-Theta_0 (median [rad]), LS1-Theta_1 (dispersion), LS1-DamageStateWeights, ...
/// Incomplete = 1 where a limit state has no fit, whose parameters are empty, or drifts no known unit.
/// Notes (pelicun passes them over): the drift up to which walls were seen, beyond which the law is
/// extrapolated.
[[nodiscard]] std::string pelicun_csv(const DriftData& data);

} // namespace app
