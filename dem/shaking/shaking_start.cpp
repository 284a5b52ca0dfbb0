#include "dem/shaking/shaking_start.hpp"

#include "dem/solver/static_start.hpp"
#include "dem/solver/step/finite_step.hpp"
#include "dem/solver/step/step.hpp"

#include <algorithm>

namespace dem {

namespace {

constexpr double kBalance = 1e-6; // [-]
constexpr long long kMostSteps = 60'000;
constexpr long long kStartLook = 50; // steps between looks

/// Leaves the wall without motion, and the energy it stores as all work so far.
void stop(const StepTables& t, WallState<double>& s)
{
    std::ranges::fill(s.v, 0.0);
    s.work = s.friction = s.fracture = s.crushing = s.damping = s.closing = 0.0;
    s.work = energy_of(t, s, 0).elastic;
}

} // namespace

ShakingStart wall_at_rest(const Model& m, const StepTables& t, const WallMaterials& w,
                          const SolverOptions& options)
{
    ShakingStart start;
    WallState<double>& s = start.wall;
    s = unloaded<double>(m, t, {&w, 1}, options);
    start.at_rest = solve_preload(t, s);
    if (!start.at_rest) return start;
    take_up_frames(t, options, s);
    for (long long i = 0; i < kMostSteps; ++i) {
        step(t, options, StepInput<double>{}, s);
        if (i % kStartLook != kStartLook - 1) continue;
        start.unbalance = unbalanced_ratio(s, 0);
        if (!(start.unbalance > kBalance)) break;
    }
    start.at_rest = start.unbalance <= kBalance;
    stop(t, s);
    return start;
}

ShakingStart released_wall(const Model& m, const StepTables& t, const WallMaterials& w,
                           const SolverOptions& options, const std::vector<Displaced>& released)
{
    ShakingStart start;
    WallState<double>& s = start.wall;
    s = unloaded<double>(m, t, {&w, 1}, options);
    for (const Displaced& d : released) {
        BlockFrame<double>& f = s.finite.frames[d.block];
        f.x += d.x;
        f.z += d.z;
        f.turn = d.turn;
        f.half = half_turn(f.turn);
    }
    advance_contacts(t, options, s);
    for (std::size_t b = 0; b < t.finite.blocks.size(); ++b) {
        const BlockFrame<double>& f = s.finite.frames[b];
        const FiniteTables::BlockRow& row = t.finite.blocks[b];
        const Turn<double> turn = whole(f.half);
        const double rise =
            f.z + row.centre_z * turn.c - row.centre_x * turn.s - (row.z + row.centre_z);
        start.raised += s.finite.weight[b] * rise;
    }
    stop(t, s);
    return start;
}

} // namespace dem
