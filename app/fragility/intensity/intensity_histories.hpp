#pragma once
/// Tables of the histories of a study, before any state is fitted.

#include "app/fragility/intensity/intensity_data.hpp"
#include "app/output/table/table.hpp"

#include <array>
#include <vector>

namespace app {

/// Quantiles of the drift at one of the intensities of a study; a wall that fell has an
/// infinite one.
struct DriftFractiles {
    double intensity = 0.0; ///< median of the histories [unit of the measure]
    std::size_t n = 0;
    std::array<double, 3> at{}; ///< 16, 50, 84 % [-]
};
[[nodiscard]] std::vector<DriftFractiles> drift_fractiles(const IntensityData& data,
                                                          std::size_t level);

/// Rows by stress and measure: how closely the measure tells the drift.
[[nodiscard]] Table measure_table(const IntensityData& data);

/// Rows by stress and intensity: drift_fractiles.
[[nodiscard]] Table fractile_table(const IntensityData& data);

/// Rows by history: its measures, drifts, outcome and mode.
[[nodiscard]] Table history_table(const IntensityData& data);

} // namespace app
