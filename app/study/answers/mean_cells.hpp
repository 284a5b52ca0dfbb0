#pragma once
/// Means and medians of many walls as cells of tables.

#include "app/output/table/cells.hpp"
#include "fragility/fits/observation.hpp"

#include <span>
#include <vector>

namespace app {

/// Mean of the sound values times `scale`, with its standard error; a single value has none.
[[nodiscard]] Number mean_cell(std::span<const double> values, int decimals,
                               double scale = 1.0);

/// Median without a law (Kaplan and Meier) with its interval (observed_quantile.hpp). Where
/// less than half of the walls got there, ">=" the largest value that was tested, and the
/// interval's lower end where it lies below.
/// @param data observed or right-censored, of weight 1
[[nodiscard]] Number median_cell(std::span<const fragility::Observation> data,
                                 double confidence, int decimals);

/// Coefficient of variation of the sound values; nothing for a single one.
[[nodiscard]] Number cov_cell(std::span<const double> values);

/// Median of plain numbers; empty without any.
[[nodiscard]] Number median_number(std::vector<double> values, int decimals);

} // namespace app
