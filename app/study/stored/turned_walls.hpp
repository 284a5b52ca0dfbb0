#pragma once
/// Walls of a study that were pushed both ways.

#include "app/study/stored/study_walls.hpp"

#include <string>

namespace app {

/// A wall of a study that was pushed both ways: the worse one stands for it. It has failed
/// where one of both has.
[[nodiscard]] StudyWall with_other_way(StudyWall wall, StudyWall other,
                                       const ReadingRules& rules);

/// The sentence for a study: how to find out about the other direction, or how often each of
/// both governs. Empty where there is no other way.
[[nodiscard]] std::string other_way_remark(const StudyWalls& walls);

} // namespace app
