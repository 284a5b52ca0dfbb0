#include "dem/shaking/shaking_step.hpp"

#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/finite_motion.hpp"
#include "dem/solver/step/finite_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem {

namespace {

template <class Real> struct Arm {
    Real x, z;
};
/// From the pivot to the centre of gravity, now.
template <class Real> Arm<Real> arm_of(const ShakenBlock<Real>& b, const Turn<Real>& turn)
{
    return {b.centre_x * turn.c + b.centre_z * turn.s,
            b.centre_z * turn.c - b.centre_x * turn.s};
}

/// All forces on a block but that of the ground's motion; the moment about its centre of
/// gravity.
template <class Real>
OuterForce<Real> force_on(const OuterForce<Real>& outer, const ShakenBlock<Real>& b,
                          const Turn<Real>& turn, const BlockFrame<Real>& frame)
{
    const Arm<Real> arm = arm_of(b, turn);
    const Real fx = frame.fx + outer.fx, fz = frame.fz + outer.fz;
    return {fx, fz, frame.moment + outer.moment - (arm.z * fx - arm.x * fz)};
}

template <class Real>
void move_block(const OuterForce<Real>& outer, const ShakingInput<Real>& in,
                const Turn<Real>& turn, ShakenBlock<Real>& b, BlockFrame<Real>& frame,
                ShakenWalls<Real>& all)
{
    const OuterForce<Real> force = force_on(outer, b, turn, frame);
    const Real gx = -(b.weight_mass * in.x), gz = -(b.weight_mass * in.z);
    const Real vx = b.vx, vz = b.vz, by_force = in.kick * b.inv_mass;
    b.vx = multiply_add(by_force, force.fx + gx, vx);
    b.vz = multiply_add(by_force, force.fz + gz, vz);
    b.spin = multiply_add(in.kick * b.inv_inertia, force.moment, b.spin);
    all.ground_work += Real(0.5) * (gx * (vx + b.vx) + gz * (vz + b.vz));
    b.x += b.vx;
    b.z += b.vz;
    const Real x = frame.x, z = frame.z;
    frame.turn += b.spin;
    frame.half = half_turn(frame.turn);
    const Arm<Real> now = arm_of(b, whole(frame.half));
    frame.x = b.x - now.x;
    frame.z = b.z - now.z;
    frame.vx = frame.x - x;
    frame.vz = frame.z - z;
    frame.spin = b.spin;
    all.fall_work += outer.fx * frame.vx + outer.fz * frame.vz + outer.moment * frame.spin;
}

template <class Real>
void move_blocks(const StepTables& t, const ShakingInput<Real>& in, ShakenWalls<Real>& all)
{
    const FiniteTables& f = t.finite;
    WallState<Real>& s = all.state;
    Real work = s.work;
    Real* force = s.block_force.data();
    s.load_x = Real(0.0);
    const Real before = all.ground_work + all.fall_work;
    for (int b = 0; b < static_cast<int>(t.blocks.size()); ++b) {
        const auto& row = t.blocks[b];
        const auto& elastic = f.elastic[row.element];
        const int* contact = t.port_contact.data() + row.first_port;
        const int first = row.first_mode + f.blocks[b].rigid;
        const Turn<Real> turn = whole(s.finite.frames[b].half);
        const OuterForce<Real> outer = outer_force(f, b, turn, Real(1.0), s);
        s.load_x += outer.fx;
        if (elastic.modes > 0)
            gather(elastic, contact, t.area.data(), s.finite.acting.data(), force);
        for (int i = 0; i < elastic.modes; ++i) {
            const int m = first + i;
            const Real load = multiply_add(s.laws.load[m], turn.c, s.finite.sway[m] * turn.s);
            const Real total = force[i] + load - s.laws.elasticity[m] * s.q[m];
            s.v[m] = multiply_add(total, s.laws.inv_mass[m], s.v[m]);
            s.q[m] += s.v[m];
            work = multiply_add(load, s.v[m], work);
        }
        if (elastic.modes > 0) scatter(elastic, contact, s.v.data() + first, s.du.data());
        if (f.blocks[b].rigid > 0)
            move_block(outer, in, turn, all.blocks[b], s.finite.frames[b], all);
    }
    s.work = work + (all.ground_work + all.fall_work - before);
}

} // namespace

template <class Real>
ShakenWalls<Real> empty_shaken(const Model& m, const StepTables& t, bool dashed)
{
    ShakenWalls<Real> all;
    all.state = empty_lanes<Real>(m, t, Kinematics::finite);
    all.blocks.resize(t.blocks.size());
    if (dashed) {
        all.state.finite.dashpots.assign(t.dry.size(), Real(0.0));
        all.state.finite.dashed.assign(2 * m.dry.size(), Real(0.0));
    }
    return all;
}

template <class Real> void clear_lane(const StepTables& t, int lane, ShakenWalls<Real>& all)
{
    clear_lane(t, lane, all.state);
    for (std::size_t k = 0; k < all.blocks.size(); ++k) {
        ShakenBlock<Real>& b = all.blocks[k];
        for (Real* x : {&b.inv_mass, &b.inv_inertia, &b.weight_mass, &b.centre_x, &b.centre_z,
                        &b.vx, &b.vz, &b.spin})
            set_lane(*x, lane, 0.0);
        set_lane(b.x, lane, t.finite.blocks[k].x);
        set_lane(b.z, lane, t.finite.blocks[k].z);
    }
    for (Real* x : {&all.ground_work, &all.fall_work, &all.supported}) set_lane(*x, lane, 0.0);
    for (auto* values : {&all.state.finite.dashpots, &all.state.finite.dashed})
        for (Real& x : *values) set_lane(x, lane, 0.0);
}

template <class Real>
void load_lane(const Model& m, const StepTables& t, const WallMaterials& w,
               const SolverOptions& options, const WallState<double>& start,
               const std::vector<BlockMass>& masses, double dt, int lane,
               ShakenWalls<Real>& all)
{
    clear_lane(t, lane, all);
    load_lane(m, t, w, options, lane, all.state);
    copy_to_lane(start, lane, all.state);
    double supported = 0.0;
    for (std::size_t k = 0; k < masses.size(); ++k) {
        const BlockMass& mass = masses[k];
        const BlockFrame<double>& frame = start.finite.frames[k];
        ShakenBlock<double> b;
        b.centre_x = mass.centre_x;
        b.centre_z = mass.centre_z;
        const Arm<double> arm = arm_of(b, whole(frame.half));
        ShakenBlock<Real>& to = all.blocks[k];
        if (mass.mass > 0.0) {
            set_lane(to.inv_mass, lane, dt * dt / mass.mass);
            set_lane(to.inv_inertia, lane, dt * dt / mass.inertia);
        } else {
            supported +=
                stone_of(m, static_cast<int>(k), w.stone).density * t.finite.blocks[k].volume;
        }
        set_lane(to.weight_mass, lane, mass.mass);
        set_lane(to.centre_x, lane, mass.centre_x);
        set_lane(to.centre_z, lane, mass.centre_z);
        set_lane(to.x, lane, frame.x + arm.x);
        set_lane(to.z, lane, frame.z + arm.z);
    }
    set_lane(all.supported, lane, supported);
}

template <class Real>
void shaking_step(const StepTables& t, const SolverOptions& options,
                  const ShakingInput<Real>& in, ShakenWalls<Real>& all)
{
    WallState<Real>& s = all.state;
    move_blocks(t, in, all);
    advance_contacts(t, options, s);
    s.base_shear = -(all.supported * in.x);
    for (const int frame : t.finite.supported) s.base_shear += s.finite.frames[frame].fx;
}

template <class Real> Real kinetic_energy(const StepTables& t, const ShakenWalls<Real>& all)
{
    Real twice(0.0);
    for (std::size_t k = 0; k < all.blocks.size(); ++k) {
        if (t.finite.blocks[k].rigid == 0) continue;
        const ShakenBlock<Real>& b = all.blocks[k];
        const BlockFrame<Real>& frame = all.state.finite.frames[k];
        const Turn<Real> turn = whole(frame.half);
        const OuterForce<Real> outer =
            outer_force(t.finite, static_cast<int>(k), turn, Real(1.0), all.state);
        const OuterForce<Real> force = force_on(outer, b, turn, frame);
        const Real half(0.5);
        const Real vx = multiply_add(half * b.inv_mass, force.fx, b.vx),
                   vz = multiply_add(half * b.inv_mass, force.fz, b.vz),
                   spin = multiply_add(half * b.inv_inertia, force.moment, b.spin);
        twice += (vx * vx + vz * vz) / b.inv_mass + spin * spin / b.inv_inertia;
    }
    return Real(0.5) * twice;
}

template <class Real>
void set_dashpots(const std::vector<double>& shares, int lane, WallState<Real>& s)
{
    for (std::size_t r = 0; r < s.finite.dashpots.size(); ++r)
        set_lane(s.finite.dashpots[r], lane, shares[r]);
}

std::vector<double> dashpot_shares(const Model& m, const StepTables& t, const WallMaterials& w,
                                   const std::vector<BlockMass>& masses,
                                   const StepLimits& limits, double zeta, double dt)
{
    std::vector<double> shares;
    for (std::size_t r = 0; r < t.dry.size(); ++r) {
        double limit = std::numeric_limits<double>::infinity();
        for (const int b : t.dry_blocks[r])
            if (b != kGround) limit = std::min(limit, limits.block[b]);
        const double mass = reduced_mass(t.dry_blocks[r], masses);
        double share = 0.0;
        if (mass > 0.0 && std::isfinite(limit)) {
            const double beta = 2.0 * zeta * std::sqrt(mass / normal_stiffness(t, r, w, m));
            const double most = 4.0 * dt * dt / (limit * limit); // k dt2 / m of the bound
            share = -std::expm1(-most * beta / dt) / most;
        }
        shares.push_back(share);
    }
    return shares;
}

template ShakenWalls<double> empty_shaken(const Model&, const StepTables&, bool);
template void clear_lane(const StepTables&, int, ShakenWalls<double>&);
template void load_lane(const Model&, const StepTables&, const WallMaterials&,
                        const SolverOptions&, const WallState<double>&,
                        const std::vector<BlockMass>&, double, int, ShakenWalls<double>&);
template void shaking_step(const StepTables&, const SolverOptions&, const ShakingInput<double>&,
                           ShakenWalls<double>&);
template double kinetic_energy(const StepTables&, const ShakenWalls<double>&);
template void set_dashpots(const std::vector<double>&, int, WallState<double>&);
template ShakenWalls<Pack> empty_shaken(const Model&, const StepTables&, bool);
template void clear_lane(const StepTables&, int, ShakenWalls<Pack>&);
template void load_lane(const Model&, const StepTables&, const WallMaterials&,
                        const SolverOptions&, const WallState<double>&,
                        const std::vector<BlockMass>&, double, int, ShakenWalls<Pack>&);
template void shaking_step(const StepTables&, const SolverOptions&, const ShakingInput<Pack>&,
                           ShakenWalls<Pack>&);
template Pack kinetic_energy(const StepTables&, const ShakenWalls<Pack>&);
template void set_dashpots(const std::vector<double>&, int, WallState<Pack>&);

} // namespace dem
