#pragma once
/// P(limit state reached | drift): tables at a grid of drifts, steps, and charts.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/fragility/numbers/fragility_output.hpp"
#include "app/output/table/table.hpp"
#include "fragility/limits/fragility_curve.hpp"

#include <vector>

namespace app {

/// Drifts at which curves are tabulated: evenly from zero to where the last runs end
/// [unit of the data]; empty without walls.
[[nodiscard]] std::vector<double> drift_grid(const DriftData& data, std::size_t state,
                                             std::size_t points);

/// Fits of all walls and of each mode, and the mixture over modes, with bands.
[[nodiscard]] Table curve_table(const DriftData& data, std::size_t state);

/// Steps without any law (Kaplan and Meier), with bands.
[[nodiscard]] Table step_table(const DriftData& data, std::size_t state);

/// Walls of one limit state by mode, without modes that do not occur; data without modes are
/// one.
[[nodiscard]] std::vector<fragility::ModeGroup>
mode_groups(const DriftData& data, std::size_t group, std::size_t state);

/// Why there is no mixture of these: values that their law does not have, or drift limits that
/// are set and nothing of the walls' own. Empty if there is one.
[[nodiscard]] std::string no_mixture(const std::vector<fragility::ModeGroup>& modes);

/// Name of the files of a limit state: "ntc_SLV".
[[nodiscard]] std::string state_file(const StateName& state);

/// One chart with all groups of each limit state, and one with modes and bands of each group
/// and limit state.
[[nodiscard]] std::vector<NamedPicture> curve_pictures(const DriftData& data);

/// The tables, for all limit states.
[[nodiscard]] std::vector<NamedTable> curve_tables(const DriftData& data);

} // namespace app
