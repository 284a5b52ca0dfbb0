#pragma once
/// Choices of the model that move a drift limit, and where one of them leaves none. Every
/// output takes its sentences from here.

#include "app/study/stored/study_walls.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct FragilityInput;
struct LoadInput;

/// The remark on a wall whose small displacements leave it no drift limit, without a full stop;
/// empty where there is a limit, or another reason.
[[nodiscard]] std::string no_limit_remark(const LoadInput& load,
                                          const dem::SolverOptions& solver,
                                          const FragilityInput& fragility,
                                          const WallReading& wall);

/// The same of the walls of a study, with their number, as a sentence; empty where every wall
/// has a limit.
[[nodiscard]] std::string no_limit_remark(const StudyWalls& walls);

/// The remark on a wall whose cycles leave it no yield, and on walls of a study.
[[nodiscard]] std::string no_yield_remark(const WallReading& wall);
[[nodiscard]] std::string no_yield_remark(const StudyWalls& walls);

/// A key whose value moves a drift limit, and how.
struct LimitChoice {
    std::string_view key;    ///< "solver.kinematics"
    std::string value;       ///< "small": that the study has
    std::string_view effect; ///< of this value
};

/// The choices that play a part in the study, the one that matters most first.
[[nodiscard]] std::vector<LimitChoice> limit_choices(const Study& study);

/// "Choices that move a drift limit: solver.kinematics = small, wall.base = fixed, ...": one
/// sentence.
[[nodiscard]] std::string limit_choices_text(std::span<const LimitChoice> choices);

} // namespace app
