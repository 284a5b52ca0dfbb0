#pragma once
/// Means of many walls as cells of tables.

#include "app/output/cells.hpp"

#include <span>

namespace app {

/// Mean of the sound values times `scale`, with its standard error; a single value has none.
[[nodiscard]] Number mean_cell(std::span<const double> values, int decimals,
                               double scale = 1.0);

/// Coefficient of variation of the sound values; nothing for a single one.
[[nodiscard]] Number cov_cell(std::span<const double> values);

} // namespace app
