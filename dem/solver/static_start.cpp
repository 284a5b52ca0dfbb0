#include "dem/solver/static_start.hpp"

#include "dem/solver/state/closing_joint.hpp"
#include "dem/solver/state/elastic_operator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace dem {

namespace {

using Vector = std::vector<double>;

constexpr double kStartTolerance = 1e-8; // relative residual in the norm of the preconditioner
constexpr int kMostStartIterations = 20000;
constexpr double kNewtonTolerance = 1e-11; // the same
constexpr int kMostNewtonSteps = 40;

/// Solves K q = load by conjugate gradients, from q = 0.
bool solve(const StepTables& t, const Vector& load, WallState<double>& s, Vector& q)
{
    const std::size_t n = q.size();
    Vector r = load, z(n), p(n, 0.0), kp(n);
    const auto precondition = [&] {
        for (std::size_t i = 0; i < n; ++i) z[i] = s.laws.inv_mass[i] * r[i];
    };
    precondition();
    double rz = dot(r, z);
    const double enough = kStartTolerance * kStartTolerance * rz;
    for (int i = 0; i < kMostStartIterations && rz > enough; ++i) {
        if (i == 0) p = z;
        apply_stiffness(t, p, s, kp);
        const double alpha = rz / dot(p, kp);
        for (std::size_t m = 0; m < n; ++m) {
            q[m] += alpha * p[m];
            r[m] -= alpha * kp[m];
        }
        precondition();
        const double next = dot(r, z), beta = next / rz;
        rz = next;
        for (std::size_t m = 0; m < n; ++m) p[m] = z[m] + beta * p[m];
    }
    return rz <= enough; // also false for NaN
}

/// Joints closed as by the vertical stress for which their k_n is given.
template <Closure kClosure> void close_as_given(const StepTables& t, WallState<double>& s)
{
    for (const ContactRun& run : t.dry) {
        const ClosureLaw<double>& c = s.laws.closing[run.law];
        const double p = max(0.0, s.laws.dry[run.law].kn - c.k0) / c.inv_maximum;
        for (int k = run.first; k < run.first + run.count; ++k)
            s.u_n[k] = -closure_at<kClosure>(c, p);
    }
}

/// Stresses of the displacements of contacts in s.du, of which the joints close, and are not
/// cut back.
template <Closure kClosure> void closing_stress(const StepTables& t, WallState<double>& s)
{
    elastic_stress(t, s, s.du, s.stress);
    for (const ContactRun& run : t.dry) {
        const ClosureLaw<double>& c = s.laws.closing[run.law];
        for (int k = run.first; k < run.first + run.count; ++k) {
            const double u_n = s.du[2 * k];
            const auto closed = closed_by<kClosure>(c, max(0.0, -u_n));
            s.u_n[k] = u_n;
            s.stress[2 * k] = u_n < 0.0 ? -closed.p : c.k0 * u_n;
            const double root = closed.root_ks(c);
            s.stress[2 * k + 1] = root * root * s.du[2 * k + 1];
        }
    }
}

/// load - K(q) [sqrt(J)], from the stresses.
Vector residual_of(const StepTables& t, const WallState<double>& s)
{
    Vector r(s.q.size());
    for (const auto& b : t.blocks) {
        double* force = r.data() + b.first_mode;
        gather(t.matrices[b.element], t.port_contact.data() + b.first_port, t.area.data(),
               s.stress.data(), force);
        for (int m = b.first_mode; m < b.first_mode + b.modes; ++m)
            r[m] += s.laws.load[m] - s.laws.elasticity[m] * s.q[m];
    }
    return r;
}

/// In the norm of the preconditioner.
double size_of(const WallState<double>& s, const Vector& r)
{
    double sum = 0.0;
    for (std::size_t m = 0; m < r.size(); ++m) sum += r[m] * s.laws.inv_mass[m] * r[m];
    return std::sqrt(sum);
}

/// Solves for the wall whose joints close, by Newton's method, from q = 0.
template <Closure kClosure> bool close_joints(const StepTables& t, WallState<double>& s)
{
    const double loads = size_of(s, s.laws.load);
    double before = std::numeric_limits<double>::infinity();
    close_as_given<kClosure>(t, s);
    Vector left = s.laws.load, by(s.q.size());
    for (int i = 0; i < kMostNewtonSteps; ++i) {
        by.assign(by.size(), 0.0);
        if (!solve(t, left, s, by)) return false;
        for (std::size_t m = 0; m < by.size(); ++m) s.q[m] += by[m];
        stretch(t, s.q, s.du);
        closing_stress<kClosure>(t, s);
        left = residual_of(t, s);
        const double now = size_of(s, left);
        if (now <= kNewtonTolerance * loads) return true;
        // Rounding leaves more where contacts are much stiffer than others, or hardly curve.
        if (now <= kStartTolerance * loads && now > 0.5 * before) return true;
        before = now;
    }
    return false;
}

bool closes(const WallState<double>& s) { return s.laws.closure != Closure::linear; }

bool solve_closed(const StepTables& t, WallState<double>& s)
{
    if (!closes(s)) return solve(t, s.laws.load, s, s.q);
    bool solved = false;
    with_closure(s.laws,
                 [&]<Closure kClosure, bool>() { solved = close_joints<kClosure>(t, s); });
    return solved;
}

/// Joints under the displacements in s.du, pressed for the first time, and the masses for it.
template <Closure kClosure, bool kLoses>
void cut_back_closing(const StepTables& t, WallState<double>& s)
{
    for (std::size_t r = 0; r < t.dry.size(); ++r) {
        const ContactRun& run = t.dry[r];
        double most = 0.0;
        for (int k = run.first; k < run.first + run.count; ++k) {
            const auto u = advance_closing<kClosure, kLoses>(
                s.laws.closing[run.law], s.laws.dry[run.law].tan_phi, ClosingState<double>{},
                s.du[2 * k], s.du[2 * k + 1]);
            s.stress[2 * k] = u.sigma;
            s.stress[2 * k + 1] = u.tau;
            s.shear[k] = u.state.shear;
            s.rest[k] = u.state.rest;
            most = std::max(most, u.pressure);
        }
        allow_for_run<kClosure>(t, r, most, s);
    }
}

/// Dry joints carry no tension, and no more shear than friction allows.
void cut_back(const StepTables& t, WallState<double>& s)
{
    if (closes(s))
        return with_closure(s.laws, [&]<Closure kClosure, bool kLoses>() {
            cut_back_closing<kClosure, kLoses>(t, s);
        });
    for (const ContactRun& run : t.dry) {
        const DryLaw<double>& law = s.laws.dry[run.law];
        for (int k = run.first; k < run.first + run.count; ++k) {
            const auto u =
                advance(law, DryState<double>{0.0, 0.0}, s.du[2 * k], s.du[2 * k + 1]);
            s.stress[2 * k] = u.sigma;
            s.stress[2 * k + 1] = u.state.tau;
        }
    }
}

} // namespace

bool solve_preload(const StepTables& t, WallState<double>& s)
{
    const bool solved = solve_closed(t, s);
    if (solved) {
        stretch(t, s.q, s.du);
        elastic_stress(t, s, s.du, s.stress);
        cut_back(t, s);
        for (int k = 0; k < t.n_contacts; ++k) s.u_n[k] = s.du[2 * k];
    } else {
        s.q.assign(s.q.size(), 0.0);
        s.u_n.assign(s.u_n.size(), 0.0);
        s.stress.assign(s.stress.size(), 0.0);
    }
    s.du.assign(s.du.size(), 0.0);
    s.work = energy_of(t, s, 0).elastic;
    return solved;
}

ElasticPush elastic_push(const StepTables& t, WallState<double>& s)
{
    const bool body = t.body_forces;
    const auto add_drive = [&] {
        for (const HorizontalShare& h : t.beam) s.du[h.row] += h.factor;
        elastic_stress(t, s, s.du, s.stress);
    };
    Vector pull = s.laws.sway;
    if (!body) {
        pull.assign(s.q.size(), 0.0);
        s.du.assign(s.du.size(), 0.0);
        add_drive();
        for (const auto& b : t.blocks)
            gather(t.matrices[b.element], t.port_contact.data() + b.first_port, t.area.data(),
                   s.stress.data(), pull.data() + b.first_mode);
    }
    ElasticPush e;
    e.rate.assign(s.q.size(), 0.0);
    const double moved = solve(t, pull, s, e.rate) ? dot(pull, e.rate) : 0.0;
    if (!(moved > 0.0)) {
        e.rate.clear();
    } else if (body) {
        const double factor = s.laws.whole_weight / moved;
        for (double& r : e.rate) r *= factor;
        e.stiffness = s.laws.whole_weight * factor;
    } else {
        stretch(t, e.rate, s.du);
        add_drive();
        for (const HorizontalShare& h : t.beam)
            e.stiffness += h.area * h.factor * s.stress[h.row];
    }
    for (std::size_t m = 0; m < e.rate.size(); ++m)
        e.mass += e.rate[m] * e.rate[m] / s.laws.inv_mass[m];
    s.du.assign(s.du.size(), 0.0);
    s.stress.assign(s.stress.size(), 0.0);
    return e;
}

template <class Real>
void copy_to_lane(const WallState<double>& wall, int lane, WallState<Real>& s)
{
    const auto copy = [lane](const Vector& from, std::vector<Real>& to) {
        for (std::size_t i = 0; i < from.size(); ++i) set_lane(to[i], lane, from[i]);
    };
    copy(wall.q, s.q);
    copy(wall.u_n, s.u_n);
    copy(wall.stress, s.stress);
    copy(wall.crushed, s.crushed);
    copy(wall.roughness, s.roughness);
    copy(wall.shear, s.shear);
    copy(wall.rest, s.rest);
    copy(wall.laws.ratio, s.laws.ratio);
    if (closes(wall)) copy(wall.laws.inv_mass, s.laws.inv_mass);
    for (std::size_t i = 0; i < wall.cracks.size(); ++i) {
        set_lane(s.cracks[i].u_max, lane, wall.cracks[i].u_max);
        set_lane(s.cracks[i].bond, lane, wall.cracks[i].bond);
        set_lane(s.cracks[i].unloading, lane, wall.cracks[i].unloading);
        set_lane(s.cracks[i].integrity, lane, wall.cracks[i].integrity);
    }
    set_lane(s.work, lane, wall.work);
    set_lane(s.friction, lane, wall.friction);
    set_lane(s.fracture, lane, wall.fracture);
    set_lane(s.crushing, lane, wall.crushing);
    set_lane(s.softened_in_tension, lane, wall.softened_in_tension);
    set_lane(s.softened_in_shear, lane, wall.softened_in_shear);
    if (!wall.finite.frames.empty()) copy_to_lane(wall.finite, lane, s.finite);
}

template void copy_to_lane(const WallState<double>&, int, WallState<double>&);
template void copy_to_lane(const WallState<double>&, int, WallState<Pack>&);

} // namespace dem
