#include "bench/nodal/nodal_scheme.hpp"

#include "dem/solver/thread_time.hpp"

#include "bench/nodal/nodal_wall.hpp"
#include "dem/contact/contact_law.hpp"
#include "dem/contact/pack.hpp"
#include "dem/solver/state/recorder.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace bench {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double sign(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// Velocity after a step under `force` (Eq. 1, unit time step), or with combined damping.
template <dem::Damping kDamping>
double next_velocity(double gamma, double force, double last_force, double v, double inv_mass)
{
    const double against =
        kDamping == dem::Damping::local ? sign(v) : 0.5 * (sign(v) - sign(force - last_force));
    return v + inv_mass * (force - gamma * std::abs(force) * against);
}

/// f -= K u
void subtract_elastic(const MatrixXd& k, const double* u, double* f)
{
    const Index count = k.rows();
    for (Index j = 0; j < count; ++j) {
        const double* column = k.data() + j * count;
        for (Index i = 0; i < count; ++i) f[i] = dem::multiply_add(-column[i], u[j], f[i]);
    }
}

/// Eq. 1 for every node of the stone.
template <dem::Damping kDamping> void move_stone(double gamma, double load_factor, NodalWall& n)
{
    for (const BlockRows& b : n.blocks) {
        double* f = &n.force[b.first];
        for (int i = 0; i < b.count; ++i) f[i] += load_factor * n.load[b.first + i];
        subtract_elastic(n.stiffness[b.element], &n.u[b.first], f);
        for (int row = b.first; row < b.first + b.count; ++row) {
            const double total = n.force[row], inv_mass = n.inv_mass[row];
            const double v =
                next_velocity<kDamping>(gamma, total, n.last_force[row], n.v[row], inv_mass);
            n.u[row] += v;
            n.v[row] = v;
            n.last_force[row] = total;
        }
    }
}

template <dem::Damping kDamping>
void move_beam(double gamma, double load_factor, double drive, NodalWall& n)
{
    ModalBeam& b = n.beam;
    const Index rows = b.phi.rows();
    VectorXd f = b.phi.transpose() * Eigen::Map<const VectorXd>(&n.force[b.first], rows);
    f += load_factor * b.load - b.lambda.cwiseProduct(b.q);
    for (Index i = 0; i < f.size(); ++i)
        b.v(i) = next_velocity<kDamping>(gamma, f(i), b.last_force(i), b.v(i), b.inv_mass(i));
    b.q += b.v;
    b.last_force = f;
    Eigen::Map<VectorXd> v(&n.v[b.first], rows);
    v.noalias() = b.phi * b.v;
    for (Index i = 0; i < rows; i += 2) v(i) += drive;
}

struct Stress {
    double sigma, tau; ///< [Pa]
};

Stress update(DryLink& c, double du_n, double du_s)
{
    const dem::DryUpdate<double> u = dem::advance(c.law, c.state, du_n, du_s);
    c.state = u.state;
    return {u.sigma, u.state.tau};
}

Stress update(CrackLink& c, double du_n, double du_s)
{
    c.state = dem::advance<dem::ContactLaw::coupled>(c.law, c.state, du_n, du_s).state;
    return {c.state.sigma, c.state.tau};
}

/// The tied contacts of the beam.
Stress update_elastic(DryLink& c, double du_n, double du_s)
{
    c.state.u_n += du_n;
    c.state.tau += c.law.ks * du_s;
    return {c.law.kn * c.state.u_n, c.state.tau};
}

template <class AnyLink, class Update>
void advance_all(std::vector<AnyLink>& links, Update law, NodalWall& n)
{
    for (AnyLink& c : links) {
        const double dx = n.v[c.b] - n.v[c.a], dz = n.v[c.b + 1] - n.v[c.a + 1];
        const Stress s = law(c, c.nx * dx + c.nz * dz, c.nz * dx - c.nx * dz);
        const double fx = c.area * (c.nx * s.sigma + c.nz * s.tau);
        const double fz = c.area * (c.nz * s.sigma - c.nx * s.tau);
        n.force[c.a] += fx;
        n.force[c.a + 1] += fz;
        n.force[c.b] -= fx;
        n.force[c.b + 1] -= fz;
    }
}

template <dem::Damping kDamping>
void step(double gamma, double load_factor, double drive, NodalWall& n)
{
    const auto any = [](auto& c, double du_n, double du_s) { return update(c, du_n, du_s); };
    move_stone<kDamping>(gamma, load_factor, n);
    move_beam<kDamping>(gamma, load_factor, drive, n);
    std::fill(n.force.begin(), n.force.end(), 0.0);
    advance_all(n.dry, any, n);
    advance_all(n.cracks, any, n);
    advance_all(n.tied, update_elastic, n);
}

/// Sum of |unbalanced force| / sum of |contact force + load|, over the nodes that are free [-].
double unbalanced_ratio(const NodalWall& n)
{
    double unbalanced = 0.0, acting = 0.0;
    for (std::size_t row = 0; row < n.load.size(); ++row) {
        if (n.inv_mass[row] == 0.0) continue;
        unbalanced += std::abs(n.last_force[row]);
        acting += std::abs(n.force[row] + n.load[row]);
    }
    return acting > 0.0 ? unbalanced / acting : 0.0;
}

/// Force of the drive on the beam [N].
double top_force(const NodalWall& n)
{
    double sum = 0.0;
    for (Index i = 0; i < n.beam.phi.rows(); i += 2) sum -= n.force[n.beam.first + i];
    return sum;
}

template <dem::Damping kDamping>
void carry_vertical_load(const NodalOptions& o, NodalWall& n, NodalPush& r)
{
    constexpr int look_every = 50; // steps
    const long long ramp = std::max(1LL, o.preload_steps / 4);
    while (r.preload_steps < o.preload_steps && r.preload_unbalance >= o.preload_unbalance) {
        const double s =
            std::min(1.0, static_cast<double>(++r.preload_steps) / static_cast<double>(ramp));
        step<kDamping>(o.damping_factor, s * s * (3.0 - 2.0 * s), 0.0, n);
        if (r.preload_steps > ramp && r.preload_steps % look_every == 0)
            r.preload_unbalance = unbalanced_ratio(n);
    }
}

/// No node moves by a metre in a step. Asked of all nodes: a NaN may hide in a block that open
/// joints cut off.
bool is_sound(const NodalWall& n)
{
    return std::all_of(n.v.begin(), n.v.end(), [](double v) { return std::abs(v) < 1.0; });
}

template <dem::Damping kDamping> void drive(const NodalOptions& o, NodalWall& n, NodalPush& r)
{
    const long long steps =
        std::max(1LL, std::llround(1e3 * o.max_displacement * o.steps_per_mm));
    const double speed = o.max_displacement / static_cast<double>(steps);
    dem::Recorder recorder(o.record_every, 0.0);
    double before = top_force(n);
    r.curve.push_back({0.0, before});
    for (long long i = 1; i <= steps; ++i, ++r.cost.steps) {
        step<kDamping>(o.damping_factor, 1.0, speed, n);
        const double after = top_force(n), position = static_cast<double>(i) * speed;
        recorder.add(speed, before, after, after);
        before = after;
        const bool room = o.max_displacement - position > 0.5 * o.record_every;
        if (i < steps && !(recorder.due() && room)) continue;
        if (!is_sound(n)) return;
        const dem::CurvePoint p = recorder.take(position, {});
        r.curve.push_back({p.displacement, p.force});
    }
}

template <dem::Damping kDamping> void run(const NodalOptions& o, NodalWall& n, NodalPush& r)
{
    carry_vertical_load<kDamping>(o, n, r);
    r.cost.steps = r.preload_steps;
    if (is_sound(n))
        drive<kDamping>(o, n, r);
    else
        r.preload_unbalance = 1.0;
    if (!is_sound(n)) r.outcome = dem::Outcome::not_finite;
}

void check(const NodalOptions& o)
{
    if (!(o.steps_per_mm > 0 && o.damping_factor >= 0 && o.damping_factor < 1 &&
          o.step_fraction > 0 && o.step_fraction <= 1 && o.preload_steps >= 0 &&
          o.max_displacement > 0 && o.record_every > 0))
        throw std::invalid_argument("nodal scheme: an option is out of range");
}

} // namespace

NodalPush push_nodes(const dem::Model& model, const dem::WallMaterials& materials,
                     const NodalOptions& options)
{
    check(options);
    const double start = dem::thread_seconds();
    // Damping adds up to gamma |F| to a force that opposes the motion, hence 1 + gamma.
    const double f = options.step_fraction;
    NodalWall n = unloaded_nodes(model, materials, (1.0 + options.damping_factor) / (f * f));
    NodalPush r;
    if (options.damping == dem::Damping::local)
        run<dem::Damping::local>(options, n, r);
    else
        run<dem::Damping::combined>(options, n, r);
    const std::size_t contacts = n.dry.size() + n.cracks.size() + n.tied.size();
    r.cost.contact_updates = r.cost.steps * static_cast<long long>(contacts);
    r.cost.seconds = dem::thread_seconds() - start;
    return r;
}

double peak_force(const NodalPush& push)
{
    double peak = 0.0;
    for (const NodalPoint& p : push.curve) peak = std::max(peak, p.force);
    return peak;
}

} // namespace bench
