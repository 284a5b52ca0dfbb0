#pragma once
/// Words of a sheet: the answer, what was assumed and how much it matters, how sure the answer
/// is.

#include "app/study/pushed/pushed_wall.hpp"
#include "app/study/stored/study_walls.hpp"

#include <string>
#include <vector>

namespace app {

struct LoadInput;
struct Study;

/// A choice of the model, what it means here, and how much it moved the answer where that was
/// measured.
struct Assumption {
    std::string what;     ///< "solver.kinematics = finite"
    std::string meaning;  ///< a sentence
    std::string how_much; ///< a sentence; empty: not measured
};

/// Part of the wall whose movement is the displacement of its push: "top", or "wall" (its mean
/// by weight) under body forces.
[[nodiscard]] std::string moving_part(const LoadInput& load);

/// A sentence that defines the drift.
[[nodiscard]] std::string drift_words(const LoadInput& load);

/// A few sentences that answer how much the wall carries, how far it goes, and how it fails.
/// @param vertical_load as HandChecks
[[nodiscard]] std::vector<std::string> answer_sentences(const LoadInput& load,
                                                        const FragilityInput& fragility,
                                                        double vertical_load,
                                                        const PushedWall& wall);

/// The choices that move the answer most, at most `most`.
[[nodiscard]] std::vector<Assumption> assumptions(const Study& study, std::size_t most);

/// Sentences on what is behind the numbers.
/// @param stored walls of the study; nullptr: one wall alone was pushed
/// @param level of `stored`
[[nodiscard]] std::vector<std::string> certainty_sentences(const Study& study,
                                                           const PushedWall& wall,
                                                           const StudyWalls* stored,
                                                           std::size_t level);

} // namespace app
