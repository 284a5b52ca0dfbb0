#pragma once
/// Columns that a study keeps of a wall: names of the numbers, and the row of one wall.

#include "app/sampling/sample_plan.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Meaning of a value per joint or crack: "of this joint ID, middle at x = 0.3 m, z = 0.2 m"
[[nodiscard]] std::string site_meaning(bool joint, const uq::Site& site);

[[nodiscard]] std::vector<Column> input_columns(const SamplePlan& plan);
[[nodiscard]] std::vector<Column> response_columns();
[[nodiscard]] std::vector<Column> count_columns();
[[nodiscard]] std::vector<Column> cost_columns();

/// Statuses are kWallOk or 1 + the outcome of a run that failed; the reason says it in words.
[[nodiscard]] WallRow row_of(WallKey key, const WallDraw& draw, const PushedWall& wall);

/// Place of a column; @throws std::out_of_range if there is none of this name
[[nodiscard]] std::size_t column_of(const std::vector<Column>& columns, std::string_view name);

} // namespace app
