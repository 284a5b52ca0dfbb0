#include "dem/solver/step/step.hpp"

#include "dem/solver/state/closing_joint.hpp"
#include "dem/solver/step/body_step.hpp"
#include "dem/solver/step/crack_kernels.hpp"
#include "dem/solver/step/damping_force.hpp"
#include "dem/solver/step/finite_step.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

namespace dem {

namespace {

/// Modal forces, leapfrog with damping, relative displacements at the contacts in this step.
template <Damping kDamping, class Real>
void move_blocks(const StepTables& t, double damping_factor, const StepInput<Real>& in,
                 WallState<Real>& s)
{
    const Real gamma(damping_factor), half(0.5);
    Real lost = s.damping, work = s.work;
    Real* force = s.block_force.data();
    for (const auto& b : t.blocks) {
        const ContactOperator& matrix = t.matrices[b.element];
        const int* contact = t.port_contact.data() + b.first_port;
        gather(matrix, contact, t.area.data(), s.stress.data(), force);
        for (int i = 0; i < b.modes; ++i) {
            const int m = b.first_mode + i;
            const Real load = in.load_factor * s.laws.load[m], before = s.v[m];
            const Real total = force[i] + load - s.laws.elasticity[m] * s.q[m];
            const Real damping = damping_force<kDamping>(gamma, total, s.last_force[m], before);
            const Real v = multiply_add(total + damping, s.laws.inv_mass[m], before);
            lost -= damping * (half * (before + v));
            work = multiply_add(load, v, work);
            s.q[m] += v;
            s.v[m] = v;
            s.last_force[m] = total;
        }
        scatter(matrix, contact, s.v.data() + b.first_mode, s.du.data());
    }
    s.damping = lost;
    s.work = work;
    for (const HorizontalShare& h : t.beam) s.du[h.row] += Real(h.factor) * in.drive;
}

/// Takes the relative displacement of a contact and leaves zero for the next step.
template <class Real> struct Relative {
    Real normal, tangential;
    Relative(WallState<Real>& s, int contact)
        : normal(s.du[2 * contact]), tangential(s.du[2 * contact + 1])
    {
        s.du[2 * contact] = s.du[2 * contact + 1] = Real(0.0);
    }
};

template <bool kCrushes, bool kWears, class Real>
void advance_dry(const StepTables& t, WallState<Real>& s)
{
    Real friction = s.friction;
    for (const ContactRun& run : t.dry) {
        const DryLaw<Real> law = s.laws.dry[run.law];
        for (int k = run.first; k < run.first + run.count; ++k) {
            Relative<Real> du(s, k);
            if constexpr (kCrushes)
                du.normal =
                    crush(s.laws.dry_crushing[run.law], k, du.normal, Real(t.area[k]), s);
            const DryState<Real> before{s.u_n[k], s.stress[2 * k + 1]};
            const DryUpdate<Real> u = advance(kWears ? worn_law(s, run.law, k) : law, before,
                                              du.normal, du.tangential);
            if constexpr (kWears)
                s.roughness[k] =
                    roughness_after(s.laws.dry_wear[run.law], s.roughness[k], u.slip, u.sigma);
            set_contact(s, k, u.state.u_n, u.sigma, u.state.tau);
            friction = multiply_add(Real(t.area[k]), u.friction, friction);
        }
    }
    s.friction = friction;
}

template <bool kCrushes, class Real> void advance_dry(const StepTables& t, WallState<Real>& s)
{
    if (s.roughness.empty())
        advance_dry<kCrushes, false>(t, s);
    else
        advance_dry<kCrushes, true>(t, s);
}

template <Closure kClosure, bool kLoses, bool kPlain, class Real>
void advance_closing_joints(const StepTables& t, WallState<Real>& s)
{
    Real friction = s.friction, closing = s.closing;
    const auto moved = [&](int k) {
        const Relative<Real> du(s, k);
        return ContactStep<Real>{du.normal, du.tangential};
    };
    const auto done = [&](int k, const ClosingUpdate<Real>& u) {
        friction = multiply_add(Real(t.area[k]), u.friction, friction);
        if constexpr (kLoses) closing = multiply_add(Real(t.area[k]), u.closing, closing);
    };
    for (std::size_t r = 0; r < t.dry.size(); ++r)
        advance_closing_run<kClosure, kLoses, kPlain>(t, r, Real(1.0), s, moved, done);
    s.friction = friction;
    s.closing = closing;
}

template <class Real> void advance_dry_joints(const StepTables& t, WallState<Real>& s)
{
    if (s.laws.closure != Closure::linear)
        with_closure(s.laws, [&]<Closure kClosure, bool kLoses>() {
            if (s.crushed.empty() && s.roughness.empty())
                advance_closing_joints<kClosure, kLoses, true>(t, s);
            else
                advance_closing_joints<kClosure, kLoses, false>(t, s);
        });
    else if (s.crushed.empty())
        advance_dry<false>(t, s);
    else
        advance_dry<true>(t, s);
}

template <class Real> void advance_tied(const StepTables& t, WallState<Real>& s)
{
    for (const ContactRun& run : t.tied) {
        const DryLaw<Real>& law = s.laws.tied[run.law];
        for (int k = run.first; k < run.first + run.count; ++k) {
            const Relative<Real> du(s, k);
            const Real u_n = s.u_n[k] + du.normal;
            const Real tau = multiply_add(law.ks, du.tangential, s.stress[2 * k + 1]);
            set_contact(s, k, u_n, law.kn * u_n, tau);
        }
    }
}

template <class Law, class Real>
void advance_cracks(const StepTables& t, bool shortcuts, WallState<Real>& s)
{
    for (const ContactRun& run : t.cracks) {
        const Law law(s.laws, run.law);
        for (int k = run.first; k < run.first + run.count; ++k) {
            Relative<Real> du(s, k);
            if (!s.crushed.empty())
                du.normal = crush_crack<Law>(t, run.law, k, du.normal, Real(1.0), s);
            move_crack(t, law, shortcuts, k, du.normal, du.tangential, Real(t.area[k]), s);
        }
    }
}

template <class Real>
Real horizontal_force(const std::vector<HorizontalShare>& shares, const WallState<Real>& s)
{
    Real sum(0.0);
    for (const HorizontalShare& h : shares)
        sum = multiply_add(Real(h.area * h.factor), s.stress[h.row], sum);
    return sum;
}

} // namespace

template <class Real>
void step(const StepTables& t, const SolverOptions& options, const StepInput<Real>& in,
          WallState<Real>& s)
{
    if (options.kinematics == Kinematics::finite) return finite_step(t, options, in, s);
    if (t.body_forces)
        move_by_body_forces(t, options, in, s);
    else if (options.damping == Damping::local)
        move_blocks<Damping::local>(t, options.damping_factor, in, s);
    else
        move_blocks<Damping::combined>(t, options.damping_factor, in, s);

    advance_dry_joints(t, s);
    advance_tied(t, s);
    with_crack_law(options.law, s.laws,
                   [&]<class Law>() { advance_cracks<Law>(t, options.shortcuts, s); });

    if (t.body_forces) {
        s.base_shear = s.body_factor * s.laws.supported_weight - horizontal_force(t.ground, s);
        return;
    }
    const Real before = s.top_force;
    s.top_force = horizontal_force(t.beam, s);
    s.base_shear = -horizontal_force(t.ground, s);
    s.work = multiply_add(Real(0.5) * (before + s.top_force), in.drive, s.work);
}

template <class Real> double unbalanced_ratio(const WallState<Real>& s, int lane)
{
    double forces = 0.0, loads = 0.0;
    for (std::size_t i = 0; i < s.last_force.size(); ++i) {
        forces += std::pow(dem::lane(s.last_force[i], lane), 2);
        loads += std::pow(dem::lane(s.laws.load[i], lane), 2);
    }
    return loads > 0.0 ? std::sqrt(forces / loads) : 0.0;
}

template void step(const StepTables&, const SolverOptions&, const StepInput<double>&,
                   WallState<double>&);
template double unbalanced_ratio(const WallState<double>&, int);
template void step(const StepTables&, const SolverOptions&, const StepInput<Pack>&,
                   WallState<Pack>&);
template double unbalanced_ratio(const WallState<Pack>&, int);

} // namespace dem
