#pragma once
/// A calibration of a study against tests.

#include <string>

namespace app {

/// For the verb calibrate: which inputs tests shall teach, and how far the model may be wrong.
struct CalibrationInput {
    std::string inputs;      ///< keys between commas, or "all"; empty: a factor alone
    bool discrepancy = true; ///< of the model under each stress
    double scatter = 0.25;   ///< scale of half-t priors, of ln [-], > 0
};

} // namespace app
