#pragma once
/// The answer of a study in one small table: the first of the verb fragility, of its folder and
/// of the page.

#include "app/fragility/numbers/fragility_data.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

namespace app {

/// A row per vertical stress: peak force, how the walls fail, the drift limit of the severest
/// limit state of each set with the doubt of the model, and how sure this is. Codes' limits
/// stand before the paper's.
/// @param data drift_data(walls)
[[nodiscard]] Table answer_table(const StudyWalls& walls, const DriftData& data);

} // namespace app
