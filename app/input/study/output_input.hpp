#pragma once
/// Sizes of the files that a study writes.

#include "dem/solver/push.hpp"

namespace app {

struct OutputInput {
    double record_every = dem::PushPlan{}.record_every; ///< [m], > 0
    double snapshot_every = 5e-4;         ///< [m], >= 0; 0: only the peak and the end
    bool paraview = true;                 ///< whether `push` writes a series
    bool single_precision_curves = false; ///< of a study's file: half the size, 7 digits
};

} // namespace app
