#pragma once
/// How the walls of a study are read.

#include "dem/scene/mechanism/mechanism.hpp"
#include "fragility/codes/code.hpp"
#include "fragility/curve/bilinear.hpp"
#include "fragility/curve/curve_reading.hpp"
#include "fragility/curve/cyclic_curve.hpp"
#include "fragility/laws/law.hpp"

#include <string>
#include <vector>

namespace app {

/// How walls are read, by every verb. Moves no wall.
struct FragilityInput {
    std::string limit_states = "paper, ntc"; ///< sets: codes, user
    std::string codes;                       ///< a file of codes, or its text; empty: none
    std::vector<fragility::Code> own_codes;  ///< read from `codes`
    std::string user_states;                 ///< "slight: 0.7 yield; severe: drop 0.5; ..."
    fragility::Crossing crossing = fragility::Crossing::first; ///< of the ultimate share
    double ultimate_share = fragility::kUltimateShare;         ///< of the peak [-], in (0, 1)
    double bilinear_share = fragility::kBilinearShare;         ///< of the peak [-], in (0, 1]
    fragility::Side backbone = fragility::Side::mean;          ///< of a push that turns back
    fragility::Law law = fragility::Law::lognormal;
    double confidence = 0.95; ///< of intervals [-], in (0, 1)
    int bootstrap = 1000;     ///< samples behind p-values, >= 0; 0: none
    dem::ModeThresholds mode;
    std::string model_factor =
        "tests"; ///< of limit drifts (app/input/study/model_factor_text.hpp)
    std::string model_factor_force = "tests"; ///< of peak forces
    // Damage states of walls that were shaken, as drifts [-], > 0.
    std::vector<double> shaken_drifts = {0.005, 0.01};
    std::vector<double> shaken_residuals = {0.002}; ///< after the shaking
    double shaken_uplift = 0.5; ///< share of the lowest joint that opens, in [0, 1)
    double pushed_limit = 0.0;  ///< drift limit of a push: 80 % of it is a state; 0: none
};

} // namespace app
