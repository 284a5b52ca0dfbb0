#include "dem/step.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace dem {

namespace {

/// |f| with the sign of x; 0 where x is 0.
template <class Real> Real with_sign_of(Real size, Real x)
{
    const Real zero(0.0);
    return select(x > zero, size, select(x < zero, -size, zero));
}

/// Damping force on a mode: Eq. 1 (local), or combined: half of it follows the change of the
/// force, so that a body in steady motion, whose force does not change, is not dragged.
template <Damping kDamping, class Real>
Real damping_force(Real gamma, Real force, Real last_force, Real velocity)
{
    const Real size = gamma * abs(force);
    if constexpr (kDamping == Damping::local) return -with_sign_of(size, velocity);
    return Real(0.5) * (with_sign_of(size, force - last_force) - with_sign_of(size, velocity));
}

/// Modal forces, leapfrog with damping, displacements of the contact points in this step.
template <Damping kDamping, class Real>
void move_blocks(const StepTables& t, double damping_factor, const StepInput<Real>& in,
                 WallState<Real>& s)
{
    const Real gamma(damping_factor);
    std::vector<Real>& last = s.last_force;
    std::array<Real, 256> force;
    std::vector<Real> large; // the beam with all its modes
    for (const auto& b : t.blocks) {
        Real* f = force.data();
        if (b.modes > static_cast<int>(force.size())) {
            large.resize(b.modes);
            f = large.data();
        }
        apply(t.to_modes[b.element], &s.force[b.first_row], f);
        for (int i = 0; i < b.modes; ++i) {
            const int m = b.first_mode + i;
            const Real load = in.load_factor * s.load[m];
            const Real total = f[i] + load - s.elasticity[m] * s.q[m];
            const Real damping = damping_force<kDamping>(gamma, total, last[m], s.v[m]);
            const Real v = multiply_add(total + damping, s.inv_mass[m], s.v[m]);
            s.damping -= damping * (Real(0.5) * (s.v[m] + v));
            s.work = multiply_add(load, v, s.work);
            s.q[m] += v;
            s.v[m] = v;
            last[m] = total;
        }
        apply(t.to_points[b.element], &s.v[b.first_mode], &s.du[b.first_row]);
    }
    for (int row = t.beam_first_row; row < t.beam_first_row + t.beam_rows; row += 2)
        s.du[row] += in.drive;
}

template <class Real> struct Relative {
    Real normal, tangential;
};

template <class Real>
Relative<Real> relative_motion(const ContactIndex& c, const std::vector<Real>& du)
{
    const Real dx = du[c.b] - du[c.a], dz = du[c.b + 1] - du[c.a + 1];
    return {Real(c.nx) * dx + Real(c.nz) * dz, Real(c.nz) * dx - Real(c.nx) * dz};
}

/// Tension pulls b back to a; positive shear stress pulls b back along the tangent.
template <class Real>
void add_force(const ContactIndex& c, Real sigma, Real tau, std::vector<Real>& force)
{
    const Real n = Real(c.area) * sigma, t = Real(c.area) * tau;
    const Real fx = Real(c.nx) * n + Real(c.nz) * t, fz = Real(c.nz) * n - Real(c.nx) * t;
    force[c.a] += fx;
    force[c.a + 1] += fz;
    force[c.b] -= fx;
    force[c.b + 1] -= fz;
}

template <class Real> void advance_dry(const StepTables& t, WallState<Real>& s)
{
    for (std::size_t k = 0; k < t.dry.size(); ++k) {
        const ContactIndex& c = t.dry[k];
        const auto [du_n, du_s] = relative_motion(c, s.du);
        const DryUpdate<Real> u = advance(s.dry_laws[c.law], s.dry[k], du_n, du_s);
        s.dry[k] = u.state;
        s.friction = multiply_add(Real(c.area), u.friction, s.friction);
        add_force(c, u.sigma, u.state.tau, s.force);
    }
}

template <class Real> void advance_tied(const StepTables& t, WallState<Real>& s)
{
    for (std::size_t k = 0; k < t.tied.size(); ++k) {
        const ContactIndex& c = t.tied[k];
        const auto [du_n, du_s] = relative_motion(c, s.du);
        DryState<Real>& state = s.tied[k];
        state.u_n += du_n;
        state.tau = multiply_add(s.tied_laws[0].ks, du_s, state.tau);
        add_force(c, s.tied_laws[0].kn * state.u_n, state.tau, s.force);
    }
}

template <ContactLaw kLaw, class Real>
void advance_cracks(const StepTables& t, WallState<Real>& s)
{
    for (std::size_t k = 0; k < t.cracks.size(); ++k) {
        const ContactIndex& c = t.cracks[k];
        const auto [du_n, du_s] = relative_motion(c, s.du);
        const CrackUpdate<Real> u = advance<kLaw>(s.crack_laws[c.law], s.cracks[k], du_n, du_s);
        s.cracks[k] = u.state;
        s.friction = multiply_add(Real(c.area), u.loss.friction, s.friction);
        s.fracture = multiply_add(Real(c.area), u.loss.fracture, s.fracture);
        add_force(c, u.state.sigma, u.state.tau, s.force);
    }
}

/// Force of the drive on the beam, and of the wall on the ground.
template <class Real> void measure_shear(const StepTables& t, WallState<Real>& s)
{
    Real top(0.0), base = s.force[t.ground_row];
    for (int row = t.beam_first_row; row < t.beam_first_row + t.beam_rows; row += 2)
        top -= s.force[row];
    for (const int row : t.support_rows) base += s.force[row];
    s.top_force = top;
    s.base_shear = base;
}

} // namespace

template <class Real>
void step(const StepTables& t, const SolverOptions& options, const StepInput<Real>& in,
          WallState<Real>& s)
{
    if (options.damping == Damping::local)
        move_blocks<Damping::local>(t, options.damping_factor, in, s);
    else
        move_blocks<Damping::combined>(t, options.damping_factor, in, s);

    s.force.assign(s.force.size(), Real(0.0));
    advance_dry(t, s);
    advance_tied(t, s);
    if (options.law == ContactLaw::coupled)
        advance_cracks<ContactLaw::coupled>(t, s);
    else
        advance_cracks<ContactLaw::uncoupled>(t, s);

    const Real before = s.top_force;
    measure_shear(t, s);
    s.work = multiply_add(Real(0.5) * (before + s.top_force), in.drive, s.work);
}

template <class Real> double unbalanced_ratio(const WallState<Real>& s, int lane)
{
    double forces = 0.0, loads = 0.0;
    for (std::size_t i = 0; i < s.last_force.size(); ++i) {
        forces += std::pow(dem::lane(s.last_force[i], lane), 2);
        loads += std::pow(dem::lane(s.load[i], lane), 2);
    }
    return loads > 0.0 ? std::sqrt(forces / loads) : 0.0;
}

template void step(const StepTables&, const SolverOptions&, const StepInput<double>&,
                   WallState<double>&);
template void step(const StepTables&, const SolverOptions&, const StepInput<Pack>&,
                   WallState<Pack>&);
template double unbalanced_ratio(const WallState<double>&, int);
template double unbalanced_ratio(const WallState<Pack>&, int);

} // namespace dem
