#pragma once
/// Drifts and studies for the tables of fragility, without running a wall.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <string>
#include <vector>

namespace scenes {

/// One group per list of drifts; negative values: right-censored at their magnitude.
[[nodiscard]] app::DriftData drifts(const std::vector<std::vector<double>>& groups);

/// n walls of each of two stresses; friction angle 20 to 44 deg in turns, mixed below 32 deg
/// with a drop at 15 mm and more, rocking above, stopped at 28 mm.
[[nodiscard]] app::StudyWalls study_walls(std::size_t n);

/// Place of a column by its name.
/// @throws std::out_of_range without one
[[nodiscard]] std::size_t column(const app::Table& table, const std::string& head);

/// A cell as people read it, by the name of its column.
[[nodiscard]] std::string cell(const app::Table& table, std::size_t row,
                               const std::string& head);

/// A number with its bounds; nothing but NaN where the cell holds none.
[[nodiscard]] app::Number number_in(const app::Table& table, std::size_t row,
                                    const std::string& head);

/// No cell reads nan or inf, in any case.
[[nodiscard]] bool sound(const app::Table& table);

} // namespace scenes
