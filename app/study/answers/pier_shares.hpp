#pragma once
/// How often each pier of a study's walls governs a limit state, and how the piers did.

#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/// A cause by which walls reach a limit state.
struct GoverningPier {
    int pier = 0;        ///< from 1; 0: not a drift limit of a pier
    int direction = 0;   ///< of the push that reaches it first: 1, -1, 0: both together
    bool reached = true; ///< false: the walls had not reached it when the push ended
    std::size_t walls = 0;
};

/// The limit states of StudyWalls::states that have a drift limit of their own; none where
/// piers are not told apart.
[[nodiscard]] std::vector<std::size_t> pier_states(const StudyWalls& study);

/// The walls of a level that the limit state is defined for, by what governs: piers first, the
/// fall of the force, those that did not reach it.
[[nodiscard]] std::vector<GoverningPier>
governing_piers(const StudyWalls& study, const StudyLevel& level, std::size_t state);

/// "pier 3 to the left"; "the fall of the force"; "not reached".
[[nodiscard]] std::string governing_text(const StudyWalls& study, const GoverningPier& who);

/// "ntc SLC by pier 2 to the right: 7, pier 3 to the left: 13; ec8 NC by ...": numbers of walls
/// of a level. Empty without piers.
[[nodiscard]] std::string pier_counts(const StudyWalls& study, const StudyLevel& level);

/// The piers in a sentence: which governs how often. Of a file that holds none, where there
/// should be, the reason why limits are not those of piers. Empty of walls without piers.
[[nodiscard]] std::string pier_sentence(const StudyWalls& study);

/// How often each pier governs, with the interval of the share. No rows without piers.
[[nodiscard]] Table pier_share_table(const StudyWalls& study);

} // namespace app
