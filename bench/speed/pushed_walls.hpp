#pragma once
/// Walls at rest under their load, then pushed for a number of steps: what a kernel is timed
/// on.

#include "dem/block/discretisation.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/step/step.hpp"
#include "scenes/paper_wall.hpp"

#include <cstddef>

namespace bench {

template <class Real> struct PushedWalls {
    dem::Model model;
    dem::StepTables tables;
    dem::SolverOptions options;
    dem::WallState<Real> state;
};

/// A register of random walls (samples of Table 5, one draw per joint), pushed at 1000 steps
/// per mm.
template <class Real>
[[nodiscard]] PushedWalls<Real>
pushed_walls(const scenes::Scene& scene, const dem::Discretisation& discretisation, int steps);

/// Steps at that speed.
template <class Real> void push_on(PushedWalls<Real>& walls, int steps);

} // namespace bench
