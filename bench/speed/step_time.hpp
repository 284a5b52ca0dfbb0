#pragma once
/// Time of a step of a wall alone or of a register of walls.

#include "bench/speed/shortest.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/step/step.hpp"

#include <algorithm>

namespace bench {

/// Shortest step after a ramp of the load, while the wall is pushed [s].
/// @param wall of a lane
template <class Real, class Materials>
[[nodiscard]] double step_time(const dem::Model& model, const dem::StepTables& tables,
                               const dem::SolverOptions& options, Materials wall)
{
    const int blocks = static_cast<int>(tables.blocks.size());
    const int ramp = std::clamp(3'000'000 / blocks, 30, 300);
    const int chunk = std::max(1, 30'000 / blocks); // about 10 ms
    dem::WallState<Real> state = dem::empty_lanes<Real>(model, tables, options.kinematics);
    for (int i = 0; i < dem::lanes<Real>; ++i)
        dem::load_lane(model, tables, wall(i), options, i, state);
    for (int i = 0; i < ramp; ++i)
        dem::step(tables, options, {Real(1.0 * (i + 1) / ramp), Real(0.0)}, state);
    const dem::StepInput<Real> push{Real(1.0), Real(1e-7)};
    return shortest(30,
                    [&] {
                        for (int i = 0; i < chunk; ++i) dem::step(tables, options, push, state);
                    }) /
           chunk;
}

} // namespace bench
