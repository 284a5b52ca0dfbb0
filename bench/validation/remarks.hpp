#pragma once
/// What the tables of the validation mean, in words, with their numbers.

#include "bench/validation/paper_comparison.hpp"

#include <string>

namespace bench {

[[nodiscard]] std::string remarks_on_tests();
/// @param last_falls of mixed-mode walls, a level each
/// @param per_joint_walls at 0.75 MPa, stratified
[[nodiscard]] std::string remarks_on_differences(const OurLevels& ours,
                                                 const std::vector<Sample>& last_falls,
                                                 const LevelStatistics& per_joint_walls);

} // namespace bench
