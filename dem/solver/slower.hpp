#pragma once
/// The same push at a lower speed, to see what the speed of the drive does to a result.

#include "dem/solver/state/solver_options.hpp"

namespace dem {

/// Options of a drive that goes `factor` times slower, > 0, once, and holds that many times the
/// accuracy.
[[nodiscard]] inline SolverOptions slower(SolverOptions options, double factor)
{
    options.accuracy /= factor;
    options.steps_per_mm *= factor;
    options.most_slowdowns = 0;
    constexpr double kMost = 1e18; // fits into long long
    const double steps = static_cast<double>(options.most_steps) * factor;
    options.most_steps = static_cast<long long>(steps < kMost ? steps : kMost);
    return options;
}

} // namespace dem
