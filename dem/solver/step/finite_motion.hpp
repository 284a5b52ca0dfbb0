#pragma once
/// How forces move a block that turns by any amount: its rigid modes and its frame.

#include "dem/solver/state/wall_state.hpp"
#include "dem/solver/step/damping_force.hpp"

#include <array>

namespace dem {

/// Step of one mode: what it gains; sums the work of the loads and of damping.
template <Damping kDamping, class Real> struct ModeStep {
    WallState<Real>& s;
    Real gamma, lost, work;
    ModeStep(double damping_factor, WallState<Real>& state)
        : s(state), gamma(damping_factor), lost(state.damping), work(state.work)
    {
    }
    /// @param total force on the mode, the load included;  held: what holds the wall to the
    /// displacement that is prescribed, which is not damped
    Real advance(int mode, Real total, Real load, Real held = Real(0.0))
    {
        const Real before = s.v[mode];
        const Real damping = damping_force<kDamping>(gamma, total, s.last_force[mode], before);
        const Real v = multiply_add(total + damping + held, s.laws.inv_mass[mode], before);
        lost -= damping * (Real(0.5) * (before + v));
        work = multiply_add(load, v, work);
        s.v[mode] = v;
        s.last_force[mode] = total;
        return v;
    }
};

/// Along the axes in which the rigid modes of a block are written.
template <class Real> struct Axes {
    Real c, s;
    Axes(bool turns, const Turn<Real>& t)
        : c(turns ? t.c : Real(1.0)), s(turns ? t.s : Real(0.0))
    {
    }
    [[nodiscard]] std::array<Real, 3> on(Real fx, Real fz, Real moment) const
    {
        return {fx * c - fz * s, fx * s + fz * c, moment};
    }
};

/// Outer forces on a block but for what its elastic modes feel.
template <class Real>
OuterForce<Real> outer_force(const FiniteTables& t, int block, const Turn<Real>& turn,
                             Real load_factor, const WallState<Real>& s)
{
    const FiniteTables::BlockRow& row = t.blocks[block];
    const Real arm_x = multiply_add(Real(row.centre_x), turn.c, Real(row.centre_z) * turn.s);
    const Real weight = load_factor * s.finite.weight[block];
    OuterForce<Real> f{Real(0.0), -weight, arm_x * weight};
    if (block == t.beam) {
        const OuterForce<Real> top =
            top_load(t.load, s.finite.frames[block], turn, load_factor * s.finite.vertical);
        f.fx += top.fx;
        f.fz += top.fz;
        f.moment += top.moment;
    }
    return f;
}

template <class Real>
void set_motion(const Axes<Real>& axes, const std::array<Real, 3>& moved,
                BlockFrame<Real>& frame)
{
    frame.vx = moved[0] * axes.c + moved[1] * axes.s;
    frame.vz = moved[1] * axes.c - moved[0] * axes.s;
    frame.spin = moved[2];
}

template <class Real> void advance(BlockFrame<Real>& frame)
{
    frame.x += frame.vx;
    frame.z += frame.vz;
    frame.turn += frame.spin;
    frame.half = half_turn(frame.turn);
}

} // namespace dem
