#pragma once
/// What a study took for given: materials, wall and loads, in words.

#include "app/output/table.hpp"
#include "app/study/study_walls.hpp"

namespace app {

/// "normal(mean 35 deg, cov 0.15)": "normal, mean 35 deg, coefficient of variation 0.15"
[[nodiscard]] std::string distribution_words(const std::string& text);

/// Stone, joints, units, beam: each value that matters with its unit, its distribution where it was drawn, what it means, and
/// whether the study file gives it.
[[nodiscard]] Table material_table(const StudyWalls& study);

/// The same of geometry, supports and loads.
[[nodiscard]] Table wall_and_load_table(const StudyWalls& study);

} // namespace app
