#pragma once
/// A study: everything one run needs, in SI, each value checked against its range and its
/// fellows.

#include "app/input/study/calibration_input.hpp"
#include "app/input/study/fragility_input.hpp"
#include "app/input/study/load_input.hpp"
#include "app/input/study/masonry.hpp"
#include "app/input/study/output_input.hpp"
#include "app/input/study/reliability_input.hpp"
#include "app/input/study/sampling.hpp"
#include "app/input/study/shaking_input.hpp"
#include "app/input/study/study_file.hpp"
#include "dem/block/discretisation.hpp"
#include "dem/scene/wall.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <vector>

namespace app {

struct Study : Masonry, Sampling {
    LoadInput load;
    dem::Fidelity fidelity = dem::Fidelity::standard;
    dem::Discretisation discretisation;
    dem::SolverOptions solver{.kinematics = dem::Kinematics::finite}; // a study asks for limits
    OutputInput output;
    ReliabilityInput reliability;
    ProgramInput program;
    CalibrationInput calibration;
    FragilityInput fragility;
    ShakingInput shaking;
    StudyFile source; ///< what was given
};

/// Without progress.
[[nodiscard]] dem::PushPlan push_plan(const Study& study);

/// The same study with every displacement of its push to the other side; a toe that is held
/// changes sides with a push that goes one way.
[[nodiscard]] Study turned_round(Study study);

} // namespace app
