#include "dem/solver/step/finite_step.hpp"

#include "dem/kinematics/overlap.hpp"
#include "dem/solver/state/closing_joint.hpp"
#include "dem/solver/step/body_step.hpp"
#include "dem/solver/step/crack_kernels.hpp"
#include "dem/solver/step/finite_motion.hpp"
#include "dem/solver/step/finite_reach.hpp"

#include <array>

namespace dem {

namespace {

/// Moves the frame of a block by its rigid modes.
template <Damping kDamping, class Real>
void move_frame(const FiniteTables& t, int block, int first_mode, const Turn<Real>& turn,
                const OuterForce<Real>& outer, const StepInput<Real>& in,
                ModeStep<kDamping, Real>& modes)
{
    const FiniteTables::BlockRow& row = t.blocks[block];
    BlockFrame<Real>& frame = modes.s.finite.frames[block];
    const Axes<Real> axes(row.turns_axes, turn);
    const auto load = axes.on(outer.fx, outer.fz, outer.moment),
               contact = axes.on(frame.fx, frame.fz, frame.moment);
    std::array<Real, 3> moved{Real(0.0), Real(0.0), Real(0.0)};
    for (int i = 0; i < row.rigid; ++i) {
        Real by_load(0.0), total(0.0);
        for (int d = 0; d < 3; ++d) {
            by_load = multiply_add(Real(row.motion[d][i]), load[d], by_load);
            total = multiply_add(Real(row.motion[d][i]), contact[d], total);
        }
        const Real v = modes.advance(first_mode + i, total + by_load, by_load);
        for (int d = 0; d < 3; ++d)
            moved[d] = multiply_add(Real(row.motion[d][i]), v, moved[d]);
    }
    set_motion(axes, moved, frame);
    if (block == t.beam) frame.vx = in.drive;
    advance(frame);
}

template <Damping kDamping, class Real>
void move_blocks(const StepTables& t, double damping_factor, const StepInput<Real>& in,
                 WallState<Real>& s)
{
    const FiniteTables& f = t.finite;
    ModeStep<kDamping, Real> modes(damping_factor, s);
    Real* force = s.block_force.data();
    s.load_x = Real(0.0);
    for (int b = 0; b < static_cast<int>(t.blocks.size()); ++b) {
        const auto& row = t.blocks[b];
        const auto& elastic = f.elastic[row.element];
        const int* contact = t.port_contact.data() + row.first_port;
        const int first = row.first_mode + f.blocks[b].rigid;
        const Turn<Real> turn = whole(s.finite.frames[b].half);
        const OuterForce<Real> outer = outer_force(f, b, turn, in.load_factor, s);
        s.load_x += outer.fx;
        if (elastic.modes > 0)
            gather(elastic, contact, t.area.data(), s.finite.acting.data(), force);
        for (int i = 0; i < elastic.modes; ++i) {
            const int m = first + i;
            const Real load = in.load_factor *
                              multiply_add(s.laws.load[m], turn.c, s.finite.sway[m] * turn.s);
            s.q[m] += modes.advance(m, force[i] + load - s.laws.elasticity[m] * s.q[m], load);
        }
        if (elastic.modes > 0) scatter(elastic, contact, s.v.data() + first, s.du.data());
        if (f.blocks[b].rigid > 0) move_frame(f, b, row.first_mode, turn, outer, in, modes);
    }
    s.damping = modes.lost;
    s.work = modes.work;
}

/// The contacts of one pair of faces in one step.
template <class Real> struct PairStep {
    Overlap<Real> overlap;
    Real gap, widening, slip; ///< changes in this step [m]
    Real share, grown;        ///< see FiniteState::Pair; grown by, in this step [-]
    StressSum<Real> sum;      ///< on the undeformed area
    Real stretched{0.0},
        sheared{0.0}; ///< sums of sigma x stretch and tau^2 on that area, of add()

    PairStep(const FiniteTables& t, const ContactRun& run, int pair, WallState<Real>& s)
        : overlap(overlap_of(t.pairs[pair], s.finite.frames[t.pairs[pair].a],
                             s.finite.frames[t.pairs[pair].b], s.finite.pairs[pair].centre)),
          slip(slip_of(overlap, s.finite.frames[t.pairs[pair].a],
                       s.finite.frames[t.pairs[pair].b])),
          share(share_of(t.pairs[pair], overlap, s.finite.pairs[pair].share,
                         crushed_ends(t, run, s)))
    {
        auto& last = s.finite.pairs[pair];
        gap = overlap.gap - last.gap;
        widening = overlap.widening - last.widening;
        grown = share - last.share;
        last = {overlap.gap,      overlap.widening,  share,      last.slip + slip,
                overlap.past_far, overlap.past_near, last.centre};
    }

    /// Relative displacement of a contact, to which its elastic part is added.
    [[nodiscard]] Real normal(Real place, Real elastic) const
    {
        return multiply_add(place, widening, gap) + elastic;
    }
    [[nodiscard]] Real tangential(Real elastic) const { return slip + elastic; }

    /// Share of before this step: it has lost what its contacts lose. Area that comes or goes
    /// does so with the energy of its new state.
    [[nodiscard]] Real before() const { return share - grown; }

    /// Sums up the forces of a contact that has its new stresses.
    void add(const StepTables& t, int k, WallState<Real>& s)
    {
        act(t, k, s.stress[2 * k], s.stress[2 * k + 1], s);
    }

    /// Stresses of a contact act on both blocks.
    void act(const StepTables& t, int k, Real sigma, Real tau, WallState<Real>& s)
    {
        const Real area(t.area[k]);
        s.finite.acting[2 * k] = share * sigma;
        s.finite.acting[2 * k + 1] = share * tau;
        sum.add(Real(t.finite.place[k]), area * sigma, area * tau);
    }

    /// And what it stores.
    /// @param stretch whose energy is stored [m]
    void add(const StepTables& t, int k, Real stretch, WallState<Real>& s)
    {
        add(t, k, s);
        store(t, k, stretch, s);
    }
    void store(const StepTables& t, int k, Real stretch, const WallState<Real>& s)
    {
        const Real tau = s.stress[2 * k + 1], area(t.area[k]);
        const Real normal_force = area * s.stress[2 * k], shear = area * tau;
        stretched = multiply_add(normal_force, stretch, stretched);
        sheared = multiply_add(shear, tau, sheared);
    }

    /// Energy that the area brings which came into contact in this step [J]. It is not work of
    /// a force, so the ledger has it with the friction.
    template <class Law> [[nodiscard]] Real brought(const Law& law) const
    {
        return grown * (Real(0.5) * multiply_add(sheared, law.inv_ks, stretched));
    }

    void press(const FiniteTables& t, int pair, WallState<Real>& s) const
    {
        s.finite.pairs[pair].centre = centre_of_pressure(overlap, sum);
        add_forces(overlap, sum.on(share), s.finite.frames[t.pairs[pair].a],
                   s.finite.frames[t.pairs[pair].b]);
    }
};

/// Takes the elastic part of a contact's relative displacement and leaves zero for the next
/// step.
template <class Real> Real take(Real& du)
{
    const Real x = du;
    du = Real(0.0);
    return x;
}

template <Closure kClosure, bool kLoses, bool kPlain, class Real>
void advance_closing_joint(const StepTables& t, std::size_t r, WallState<Real>& s)
{
    const ContactRun& run = t.dry[r];
    const int pair = static_cast<int>(r);
    PairStep<Real> step(t.finite, run, pair, s);
    const bool grows = any((step.grown > Real(0.0)) | (step.grown < Real(0.0)));
    const ClosureLaw<Real>& law = s.laws.closing[run.law];
    Real friction(0.0), closing(0.0), stored(0.0); // [J]
    const auto moved = [&](int k) {
        const Real du_n = take(s.du[2 * k]), du_s = take(s.du[2 * k + 1]);
        return ContactStep<Real>{step.normal(Real(t.finite.place[k]), du_n),
                                 step.tangential(du_s)};
    };
    const auto done = [&](int k, const ClosingUpdate<Real>& u) {
        const Real area(t.area[k]);
        friction = multiply_add(area, u.friction, friction);
        if constexpr (kLoses) closing = multiply_add(area, u.closing, closing);
        if (grows) stored = multiply_add(area, stored_energy<kClosure>(law, u.state), stored);
        step.add(t, k, s);
    };
    advance_closing_run<kClosure, kLoses, kPlain>(t, r, step.before(), s, moved, done);
    s.friction += step.share * friction - step.grown * stored;
    if constexpr (kLoses) s.closing += step.share * closing;
    step.press(t.finite, pair, s);
}

/// The dashpots of one pair of faces. They act in closed contacts, never pull, and never exceed
/// friction together with the stresses of the law.
template <class Real> struct Dashpots {
    Real of_stiffness;            ///< stress for k times the displacement in this step [-]
    Real before{0.0}, after{0.0}; ///< sums of area x stress x displacement [J]

    /// Sets the stresses of a contact that has those of its law, and adds up their work: a
    /// force works on the mean of the velocities before and after it.
    void set(const StepTables& t, const DryLaw<Real>& law, int k, Real du_n, Real du_s,
             WallState<Real>& s)
    {
        Real &normal = s.finite.dashed[2 * k], &tangential = s.finite.dashed[2 * k + 1];
        const Real sigma = s.stress[2 * k], tau = s.stress[2 * k + 1], area(t.area[k]);
        before = multiply_add(area, normal * du_n + tangential * du_s, before);
        normal =
            min(-sigma, select(sigma < Real(0.0), of_stiffness * law.kn * du_n, Real(0.0)));
        const Real limit = -((sigma + normal) * law.tan_phi);
        tangential = max(-limit, min(limit, tau + of_stiffness * law.ks * du_s)) - tau;
        after = multiply_add(area, normal * du_n + tangential * du_s, after);
    }
};

template <bool kWears, bool kDamps, class Real>
void advance_dry(const StepTables& t, const ContactRun& run, int pair, WallState<Real>& s)
{
    const DryLaw<Real> law = s.laws.dry[run.law];
    PairStep<Real> step(t.finite, run, pair, s);
    Dashpots<Real> dashpots{kDamps ? s.finite.dashpots[pair] : Real(0.0)};
    Real friction(0.0);
    for (int k = run.first; k < run.first + run.count; ++k) {
        Real du_n = step.normal(Real(t.finite.place[k]), take(s.du[2 * k]));
        if (!s.crushed.empty())
            du_n = crush(s.laws.dry_crushing[run.law], k, du_n, step.before() * Real(t.area[k]),
                         s);
        const Real du_s = step.tangential(take(s.du[2 * k + 1]));
        const DryUpdate<Real> u = advance(kWears ? worn_law(s, run.law, k) : law,
                                          {s.u_n[k], s.stress[2 * k + 1]}, du_n, du_s);
        if constexpr (kWears)
            s.roughness[k] =
                roughness_after(s.laws.dry_wear[run.law], s.roughness[k], u.slip, u.sigma);
        set_contact(s, k, u.state.u_n, u.sigma, u.state.tau);
        friction = multiply_add(Real(t.area[k]), u.friction, friction);
        step.store(t, k, u.state.u_n, s);
        if constexpr (kDamps) {
            dashpots.set(t, law, k, du_n, du_s, s);
            step.act(t, k, u.sigma + s.finite.dashed[2 * k],
                     u.state.tau + s.finite.dashed[2 * k + 1], s);
        } else {
            step.act(t, k, u.sigma, u.state.tau, s);
        }
    }
    s.friction += step.share * friction - step.brought(law);
    if constexpr (kDamps)
        s.damping +=
            Real(0.5) * (step.before() * dashpots.before + step.share * dashpots.after);
    step.press(t.finite, pair, s);
}

template <class Real> void advance_dry_joints(const StepTables& t, WallState<Real>& s)
{
    const bool wears = !s.roughness.empty(), damps = !s.finite.dashpots.empty();
    const auto all = [&]<bool kWears, bool kDamps>() {
        int pair = 0;
        for (const ContactRun& run : t.dry) advance_dry<kWears, kDamps>(t, run, pair++, s);
    };
    if (damps)
        wears ? all.template operator()<true, true>() : all.template operator()<false, true>();
    else
        wears ? all.template operator()<true, false>()
              : all.template operator()<false, false>();
}

template <class Real>
void advance_tied(const StepTables& t, const ContactRun& run, int pair, WallState<Real>& s)
{
    const DryLaw<Real>& law = s.laws.tied[run.law];
    PairStep<Real> step(t.finite, run, pair, s);
    for (int k = run.first; k < run.first + run.count; ++k) {
        const Real u_n = s.u_n[k] + step.normal(Real(t.finite.place[k]), take(s.du[2 * k]));
        const Real tau =
            multiply_add(law.ks, step.tangential(take(s.du[2 * k + 1])), s.stress[2 * k + 1]);
        set_contact(s, k, u_n, law.kn * u_n, tau);
        step.add(t, k, u_n, s);
    }
    s.friction -= step.brought(law);
    step.press(t.finite, pair, s);
}

template <class Law, class Real>
void advance_cracks(const StepTables& t, bool shortcuts, int pair, WallState<Real>& s)
{
    for (const ContactRun& run : t.cracks) {
        const Law law(s.laws, run.law);
        PairStep<Real> step(t.finite, run, pair, s);
        for (int k = run.first; k < run.first + run.count; ++k) {
            Real du_n = step.normal(Real(t.finite.place[k]), take(s.du[2 * k]));
            if (!s.crushed.empty())
                du_n = crush_crack<Law>(t, run.law, k, du_n, step.before(), s);
            const Real du_s = step.tangential(take(s.du[2 * k + 1]));
            move_crack(t, law, shortcuts, k, du_n, du_s, step.share * Real(t.area[k]), s);
            step.add(t, k, s.u_n[k] - Law::propped(crack_state(t, s, k)), s);
        }
        s.friction -= step.brought(law.law);
        step.press(t.finite, pair, s);
        ++pair;
    }
}

template <class Real> Real horizontal_force(const FiniteTables& t, const WallState<Real>& s)
{
    Real sum(0.0);
    for (const int frame : t.supported) sum += s.finite.frames[frame].fx;
    return sum;
}

} // namespace

template <class Real>
void advance_contacts(const StepTables& t, const SolverOptions& options, WallState<Real>& s)
{
    for (BlockFrame<Real>& f : s.finite.frames) f.fx = f.fz = f.moment = Real(0.0);
    if (s.laws.closure == Closure::linear)
        advance_dry_joints(t, s);
    else
        with_closure(s.laws, [&]<Closure kClosure, bool kLoses>() {
            const bool plain = s.crushed.empty() && s.roughness.empty();
            for (std::size_t r = 0; r < t.dry.size(); ++r)
                plain ? advance_closing_joint<kClosure, kLoses, true>(t, r, s)
                      : advance_closing_joint<kClosure, kLoses, false>(t, r, s);
        });
    advance_reaches(t, s);
    int pair = static_cast<int>(t.dry.size());
    for (const ContactRun& run : t.tied) advance_tied(t, run, pair++, s);
    with_crack_law(options.law, s.laws,
                   [&]<class Law>() { advance_cracks<Law>(t, options.shortcuts, pair, s); });
}

template <class Real>
void finite_step(const StepTables& t, const SolverOptions& options, const StepInput<Real>& in,
                 WallState<Real>& s)
{
    if (t.body_forces) {
        move_by_body_forces(t, options, in, s);
        advance_contacts(t, options, s);
        s.base_shear = horizontal_force(t.finite, s) + s.body_factor * s.laws.supported_weight;
        return;
    }
    if (options.damping == Damping::local)
        move_blocks<Damping::local>(t, options.damping_factor, in, s);
    else
        move_blocks<Damping::combined>(t, options.damping_factor, in, s);
    s.work = multiply_add(s.load_x, in.drive, s.work);
    advance_contacts(t, options, s);

    const Real before = s.top_force;
    s.top_force = -(s.finite.frames[t.finite.beam].fx + s.load_x);
    s.base_shear = horizontal_force(t.finite, s);
    s.work = multiply_add(Real(0.5) * (before + s.top_force), in.drive, s.work);
}

void take_up_frames(const StepTables& t, const SolverOptions& options, WallState<double>& s)
{
    for (std::size_t b = 0; b < t.blocks.size(); ++b) {
        const FiniteTables::BlockRow& row = t.finite.blocks[b];
        BlockFrame<double>& f = s.finite.frames[b];
        double moved[3] = {0.0, 0.0, 0.0};
        for (int i = 0; i < row.rigid; ++i) {
            const double q = take(s.q[t.blocks[b].first_mode + i]);
            for (int d = 0; d < 3; ++d) moved[d] += row.motion[d][i] * q;
        }
        f.x += moved[0];
        f.z += moved[1];
        f.turn += moved[2];
        f.half = half_turn(f.turn);
    }
    for (std::size_t p = 0; p < t.finite.pairs.size(); ++p) {
        const FacePair& pair = t.finite.pairs[p];
        const auto o = overlap_of(pair, s.finite.frames[pair.a], s.finite.frames[pair.b],
                                  s.finite.pairs[p].centre);
        s.finite.pairs[p].gap = o.gap;
        s.finite.pairs[p].widening = o.widening;
    }
    advance_contacts(t, options, s);
}

template void advance_contacts(const StepTables&, const SolverOptions&, WallState<double>&);
template void advance_contacts(const StepTables&, const SolverOptions&, WallState<Pack>&);
template void finite_step(const StepTables&, const SolverOptions&, const StepInput<double>&,
                          WallState<double>&);
template void finite_step(const StepTables&, const SolverOptions&, const StepInput<Pack>&,
                          WallState<Pack>&);

} // namespace dem
