#include "dem/shaking/shaking_step.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/finite_motion.hpp"
#include "dem/solver/finite_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dem {

namespace {

struct Arm {
    double x, z;
};
/// From the pivot to the centre of gravity, now.
Arm arm_of(const ShakenBlock& b, const Turn<double>& turn)
{
    return {b.centre_x * turn.c + b.centre_z * turn.s,
            b.centre_z * turn.c - b.centre_x * turn.s};
}

void move_block(const OuterForce<double>& outer, const GroundAcceleration& ground, double kick,
                const Turn<double>& turn, ShakenBlock& b, BlockFrame<double>& frame,
                ShakenBlocks& all)
{
    const Arm arm = arm_of(b, turn);
    const double gx = -b.weight_mass * ground.x, gz = -b.weight_mass * ground.z;
    const double fx = frame.fx + outer.fx, fz = frame.fz + outer.fz;
    const double moment = frame.moment + outer.moment - (arm.z * fx - arm.x * fz);
    const double vx = b.vx, vz = b.vz;
    b.vx += kick * (fx + gx) / b.mass;
    b.vz += kick * (fz + gz) / b.mass;
    b.spin += kick * moment / b.inertia;
    all.ground_work += 0.5 * (gx * (vx + b.vx) + gz * (vz + b.vz));
    b.x += b.vx;
    b.z += b.vz;
    const double x = frame.x, z = frame.z;
    frame.turn += b.spin;
    frame.half = half_turn(frame.turn);
    const Arm now = arm_of(b, whole(frame.half));
    frame.x = b.x - now.x;
    frame.z = b.z - now.z;
    frame.vx = frame.x - x;
    frame.vz = frame.z - z;
    frame.spin = b.spin;
    all.fall_work += outer.fx * frame.vx + outer.fz * frame.vz + outer.moment * frame.spin;
}

void move_blocks(const StepTables& t, const GroundAcceleration& ground, double kick,
                 ShakenBlocks& all, WallState<double>& s)
{
    const FiniteTables& f = t.finite;
    ModeStep<Damping::combined, double> modes(0.0, s);
    double* force = s.block_force.data();
    s.load_x = 0.0;
    const double before = all.ground_work + all.fall_work;
    for (int b = 0; b < static_cast<int>(t.blocks.size()); ++b) {
        const auto& row = t.blocks[b];
        const auto& elastic = f.elastic[row.element];
        const int* contact = t.port_contact.data() + row.first_port;
        const int first = row.first_mode + f.blocks[b].rigid;
        const Turn<double> turn = whole(s.finite.frames[b].half);
        const OuterForce<double> outer = outer_force(f, b, turn, 1.0, s);
        s.load_x += outer.fx;
        if (elastic.modes > 0)
            gather(elastic, contact, t.area.data(), s.finite.acting.data(), force);
        for (int i = 0; i < elastic.modes; ++i) {
            const int m = first + i;
            const double load = s.laws.load[m] * turn.c + s.finite.sway[m] * turn.s;
            s.q[m] += modes.advance(m, force[i] + load - s.laws.elasticity[m] * s.q[m], load);
        }
        if (elastic.modes > 0) scatter(elastic, contact, s.v.data() + first, s.du.data());
        if (all.blocks[b].mass > 0.0)
            move_block(outer, ground, kick, turn, all.blocks[b], s.finite.frames[b], all);
    }
    s.work = modes.work + (all.ground_work + all.fall_work - before);
}

} // namespace

ShakenBlocks shaken_blocks(const Model& m, const StepTables& t, const WallMaterials& w,
                           const std::vector<BlockMass>& masses, double dt,
                           const WallState<double>& s)
{
    ShakenBlocks all;
    for (int k = 0; k < static_cast<int>(masses.size()); ++k) {
        const BlockMass& mass = masses[k];
        const BlockFrame<double>& frame = s.finite.frames[k];
        ShakenBlock b;
        b.mass = mass.mass / (dt * dt);
        b.inertia = mass.inertia / (dt * dt);
        b.weight_mass = mass.mass;
        b.centre_x = mass.centre_x;
        b.centre_z = mass.centre_z;
        const Arm arm = arm_of(b, whole(frame.half));
        b.x = frame.x + arm.x;
        b.z = frame.z + arm.z;
        if (!(mass.mass > 0.0))
            all.supported += stone_of(m, k, w.stone).density * t.finite.blocks[k].volume;
        all.blocks.push_back(b);
    }
    return all;
}

void shaking_step(const StepTables& t, const SolverOptions& options,
                  const GroundAcceleration& ground, double kick, ShakenBlocks& all,
                  WallState<double>& s)
{
    move_blocks(t, ground, kick, all, s);
    advance_contacts(t, options, s);
    s.base_shear = -all.supported * ground.x;
    for (const int frame : t.finite.supported) s.base_shear += s.finite.frames[frame].fx;
}

double kinetic_energy(const ShakenBlocks& all)
{
    double sum = 0.0;
    for (const ShakenBlock& b : all.blocks)
        sum += 0.5 * (b.mass * (b.vx * b.vx + b.vz * b.vz) + b.inertia * b.spin * b.spin);
    return sum;
}

void add_dashpots(const Model& m, const StepTables& t, const WallMaterials& w,
                  const std::vector<BlockMass>& masses, const StepLimits& limits, double zeta,
                  double dt, WallState<double>& s)
{
    if (zeta == 0.0) return;
    s.finite.dashed.assign(static_cast<std::size_t>(2) * m.dry.size(), 0.0);
    for (std::size_t r = 0; r < t.dry.size(); ++r) {
        double limit = std::numeric_limits<double>::infinity();
        for (const int b : t.dry_blocks[r])
            if (b != kGround) limit = std::min(limit, limits.block[b]);
        const double mass = reduced_mass(t.dry_blocks[r], masses);
        double share =
            0.0; // of the stiffness: stress of the dashpot for the displacement in a step
        if (mass > 0.0 && std::isfinite(limit)) {
            const double beta = 2.0 * zeta * std::sqrt(mass / normal_stiffness(t, r, w, m));
            const double most = 4.0 * dt * dt / (limit * limit); // k dt2 / m of the bound
            share = -std::expm1(-most * beta / dt) / most;
        }
        s.finite.dashpots.push_back(share);
    }
}

} // namespace dem
