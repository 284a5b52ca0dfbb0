#pragma once
/// How likely each failure mode is on a wall that was never run: a multinomial logit in the
/// coordinates of the inputs.

#include "app/study/stored/study_walls.hpp"
#include "app/surrogate/surrogate_data.hpp"
#include "fragility/modes/mode_model.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/// Modes of the walls of one stress against their inputs.
struct ModePoints {
    Eigen::MatrixXd coordinates; ///< walls x inputs
    std::vector<int> mode;       ///< kRocking, kSliding or kMixed
    std::string no_coordinates;  ///< as SurrogatePoints has it
};

/// @param most walls, the first of the level
[[nodiscard]] ModePoints mode_points(const StudyWalls& walls, std::size_t level,
                                     const std::vector<std::size_t>& inputs,
                                     std::size_t most = kMostSurrogateWalls);

struct ModeSurrogate {
    std::size_t walls = 0;
    std::vector<int> modes;     ///< that occur, in the order of dem::FailureMode
    fragility::ModeModel model; ///< of these modes; only where `none` is empty
    double skill = 0.0; ///< 1 - Brier score / Brier score of the shares, on walls left out [-]
    double right = 0.0; ///< walls left out whose likeliest mode is theirs [-]
    std::string none;   ///< why there is no model: a sentence; empty: there is one
    std::vector<std::string> doubts; ///< whole sentences; empty: it is to be trusted
};

/// Errors are those on each tenth of the walls, by models of the other nine.
[[nodiscard]] ModeSurrogate fit_mode_surrogate(const ModePoints& points);

} // namespace app
