#include "dem/solver/step/body_step.hpp"

#include "dem/solver/step/finite_motion.hpp"

namespace dem {

namespace {

/// Sums over the modes of what the constraint needs.
template <class Real> struct Conjugate {
    Real moved{0.0};    ///< p . v*
    Real mobility{0.0}; ///< p . p / m
    /// Change of the body force that moves the wall by what is prescribed; 0 where nothing is.
    [[nodiscard]] Real change(const WallState<Real>& s, const StepInput<Real>& in) const
    {
        const Real missing = s.laws.whole_weight * in.drive - moved;
        return select(in.held > Real(0.0), missing / max(mobility, Real(1e-300)), Real(0.0));
    }
};

/// Forces on one mode, under the last body force and without damping.
template <class Real>
void set_forces(int m, Real inner, Real load, Real pull, WallState<Real>& s,
                Conjugate<Real>& sum)
{
    const Real total = multiply_add(s.body_factor, pull, inner + load);
    const Real v = multiply_add(total, s.laws.inv_mass[m], s.v[m]);
    sum.moved = multiply_add(pull, v, sum.moved);
    sum.mobility = multiply_add(pull * pull, s.laws.inv_mass[m], sum.mobility);
    s.total[m] = total;
    s.loaded[m] = load;
    s.pull[m] = pull;
}

template <class Real>
Conjugate<Real> small_forces(const StepTables& t, const StepInput<Real>& in, WallState<Real>& s)
{
    Conjugate<Real> sum;
    Real* force = s.block_force.data();
    for (const auto& b : t.blocks) {
        gather(t.matrices[b.element], t.port_contact.data() + b.first_port, t.area.data(),
               s.stress.data(), force);
        for (int i = 0; i < b.modes; ++i) {
            const int m = b.first_mode + i;
            set_forces(m, force[i] - s.laws.elasticity[m] * s.q[m],
                       in.load_factor * s.laws.load[m], s.laws.sway[m], s, sum);
        }
    }
    return sum;
}

template <class Real> void small_motion(const StepTables& t, int block, WallState<Real>& s)
{
    const auto& b = t.blocks[block];
    for (int m = b.first_mode; m < b.first_mode + b.modes; ++m) s.q[m] += s.v[m];
    scatter(t.matrices[b.element], t.port_contact.data() + b.first_port,
            s.v.data() + b.first_mode, s.du.data());
}

/// Forces on the rigid modes of a block, along the axes in which they are written.
template <class Real>
void rigid_forces(const StepTables& t, int block, const Turn<Real>& turn, Real load_factor,
                  WallState<Real>& s, Conjugate<Real>& sum)
{
    const FiniteTables::BlockRow& row = t.finite.blocks[block];
    const OuterForce<Real> outer = outer_force(t.finite, block, turn, load_factor, s);
    s.load_x += outer.fx;
    const BlockFrame<Real>& frame = s.finite.frames[block];
    const Real weight = s.finite.weight[block],
               arm_z = Real(row.centre_z) * turn.c - Real(row.centre_x) * turn.s;
    const Axes<Real> axes(row.turns_axes, turn);
    const auto load = axes.on(outer.fx, outer.fz, outer.moment),
               contact = axes.on(frame.fx, frame.fz, frame.moment),
               body = axes.on(weight, Real(0.0), arm_z * weight);
    for (int i = 0; i < row.rigid; ++i) {
        Real by_load(0.0), by_contact(0.0), pull(0.0);
        for (int d = 0; d < 3; ++d) {
            by_load = multiply_add(Real(row.motion[d][i]), load[d], by_load);
            by_contact = multiply_add(Real(row.motion[d][i]), contact[d], by_contact);
            pull = multiply_add(Real(row.motion[d][i]), body[d], pull);
        }
        set_forces(t.blocks[block].first_mode + i, by_contact, by_load, pull, s, sum);
    }
}

template <class Real>
Conjugate<Real> finite_forces(const StepTables& t, const StepInput<Real>& in,
                              WallState<Real>& s)
{
    Conjugate<Real> sum;
    Real* force = s.block_force.data();
    s.load_x = Real(0.0);
    for (int b = 0; b < static_cast<int>(t.blocks.size()); ++b) {
        const auto& row = t.blocks[b];
        const auto& elastic = t.finite.elastic[row.element];
        const Turn<Real> turn = whole(s.finite.frames[b].half);
        if (elastic.modes > 0)
            gather(elastic, t.port_contact.data() + row.first_port, t.area.data(),
                   s.finite.acting.data(), force);
        for (int i = 0; i < elastic.modes; ++i) {
            const int m = row.first_mode + t.finite.blocks[b].rigid + i;
            const Real load = in.load_factor *
                              multiply_add(s.laws.load[m], turn.c, s.finite.sway[m] * turn.s);
            const Real pull = s.laws.sway[m] * turn.c - s.laws.weight[m] * turn.s;
            set_forces(m, force[i] - s.laws.elasticity[m] * s.q[m], load, pull, s, sum);
        }
        rigid_forces(t, b, turn, in.load_factor, s, sum);
    }
    return sum;
}

/// The velocities are those of this step; frames and elastic modes follow.
template <class Real> void finite_motion(const StepTables& t, int block, WallState<Real>& s)
{
    const auto& b = t.blocks[block];
    const FiniteTables::BlockRow& row = t.finite.blocks[block];
    const auto& elastic = t.finite.elastic[b.element];
    const int first = b.first_mode + row.rigid;
    for (int m = first; m < first + elastic.modes; ++m) s.q[m] += s.v[m];
    if (elastic.modes > 0)
        scatter(elastic, t.port_contact.data() + b.first_port, s.v.data() + first, s.du.data());
    if (row.rigid == 0) return;
    BlockFrame<Real>& frame = s.finite.frames[block];
    std::array<Real, 3> moved{Real(0.0), Real(0.0), Real(0.0)};
    for (int i = 0; i < row.rigid; ++i)
        for (int d = 0; d < 3; ++d)
            moved[d] = multiply_add(Real(row.motion[d][i]), s.v[b.first_mode + i], moved[d]);
    set_motion(Axes<Real>(row.turns_axes, whole(frame.half)), moved, frame);
    advance(frame);
}

/// Adds a change of the body force to all modes, and damping to the sums. Damping sees the
/// forces that are left once the constraint holds: it would drag the wall by what only balances
/// the constraint.
template <Damping kDamping, class Real>
Conjugate<Real> damped(Real gamma, Real change, WallState<Real>& s)
{
    Conjugate<Real> sum;
    for (std::size_t m = 0; m < s.v.size(); ++m) {
        const Real pull = s.pull[m], total = multiply_add(change, pull, s.total[m]);
        const Real damping = damping_force<kDamping>(gamma, total, s.last_force[m], s.v[m]);
        const Real v = multiply_add(total + damping, s.laws.inv_mass[m], s.v[m]);
        sum.moved = multiply_add(pull, v, sum.moved);
        sum.mobility = multiply_add(pull * pull, s.laws.inv_mass[m], sum.mobility);
        s.total[m] = total;
    }
    return sum;
}

template <Damping kDamping, class Real>
void move(const StepTables& t, double damping_factor, const StepInput<Real>& in,
          WallState<Real>& s)
{
    const bool finite = !s.finite.frames.empty();
    const Conjugate<Real> free = finite ? finite_forces(t, in, s) : small_forces(t, in, s);
    const Real undamped = free.change(s, in);
    const Real rest = damped<kDamping>(Real(damping_factor), undamped, s).change(s, in);
    ModeStep<kDamping, Real> modes(damping_factor, s);
    for (int b = 0; b < static_cast<int>(t.blocks.size()); ++b) {
        const auto& row = t.blocks[b];
        for (int m = row.first_mode; m < row.first_mode + row.modes; ++m)
            modes.advance(m, s.total[m], s.loaded[m], rest * s.pull[m]);
        finite ? finite_motion(t, b, s) : small_motion(t, b, s);
    }
    s.body_factor += undamped + rest;
    s.damping = modes.lost;
    s.top_force = s.body_factor * s.laws.whole_weight;
    s.work = multiply_add(s.top_force, in.drive, modes.work);
}

} // namespace

template <class Real>
void move_by_body_forces(const StepTables& t, const SolverOptions& options,
                         const StepInput<Real>& in, WallState<Real>& s)
{
    if (options.damping == Damping::local)
        move<Damping::local>(t, options.damping_factor, in, s);
    else
        move<Damping::combined>(t, options.damping_factor, in, s);
}

template void move_by_body_forces(const StepTables&, const SolverOptions&,
                                  const StepInput<double>&, WallState<double>&);
template void move_by_body_forces(const StepTables&, const SolverOptions&,
                                  const StepInput<Pack>&, WallState<Pack>&);

} // namespace dem
