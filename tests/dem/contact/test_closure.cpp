/// Joints that close under pressure: the law, stacks, a rocking block, masses, and the same
/// bits in every lane.

#include "dem/contact/closure.hpp"

#include "dem/block/model.hpp"
#include "dem/scene/paper_materials.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/state/closing_joint.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/stability_limit.hpp"
#include "dem/solver/step/step.hpp"
#include "tests/dem/random_lanes.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

using dem::Closure;

constexpr double kInitial = 4.866e9, kMaximum = 0.1537e-3; // [Pa/m] [m], of the paper's Table 3
constexpr double kTanPhi = 0.62;

dem::ClosureLaw<double> law(Closure closure, double loss = 0.0,
                            double stiffest = 1e3 * kInitial)
{
    return dem::closure_law(closure, kInitial, kMaximum, stiffest, loss, 1.0 / 2.4);
}

double exact_pressure(Closure closure, double w)
{
    return closure == Closure::hyperbolic ? kInitial * w / (1.0 - w / kMaximum)
                                          : kInitial * kMaximum * std::expm1(w / kMaximum);
}

double exact_closure(Closure closure, double p)
{
    return closure == Closure::hyperbolic ? p / (kInitial + p / kMaximum)
                                          : kMaximum * std::log1p(p / (kInitial * kMaximum));
}

/// Integral of the pressure [J/m2].
double exact_energy(Closure closure, double w)
{
    const double x = w / kMaximum, unit = kInitial * kMaximum * kMaximum;
    return unit * (closure == Closure::hyperbolic ? -std::log1p(-x) - x : std::expm1(x) - x);
}

/// Calls `work.operator()<closure>()` for both laws.
template <class Work> void for_both(Work&& work)
{
    work.template operator()<Closure::hyperbolic>();
    work.template operator()<Closure::exponential>();
}

/// A contact that is led along a path, with its work.
template <Closure kClosure> struct Contact {
    dem::ClosureLaw<double> law;
    dem::ClosingState<double> state{0.0, 0.0, 0.0};
    double sigma = 0.0, tau = 0.0, work = 0.0, lost = 0.0, least_loss = 0.0;

    void move(double du_n, double du_s)
    {
        const auto u = dem::advance_closing<kClosure, true>(law, kTanPhi, state, du_n, du_s);
        work += 0.5 * (sigma + u.sigma) * du_n + 0.5 * (tau + u.tau) * du_s;
        lost += u.friction;
        least_loss = std::min(least_loss, u.friction);
        state = u.state;
        sigma = u.sigma;
        tau = u.tau;
    }
    void go(double u_n, double u_s, int steps)
    {
        const double n = (u_n - state.u_n) / steps;
        for (int i = 0; i < steps; ++i) move(n, u_s / steps);
    }
    [[nodiscard]] double stored() const { return dem::stored_energy<kClosure>(law, state); }
};

scenes::Scene closing_wall(Closure closure, double loss = 0.0)
{
    scenes::Scene s = small_wall::scene();
    s.closure = closure;
    s.joint.closing = {kInitial, kMaximum, loss, 100.0 * kInitial};
    return s;
}

} // namespace

TEST_CASE("closure: pressure, tangent, inverse and energy are the closed forms",
          "[dem][closure]")
{
    for_both([]<Closure kClosure>() {
        const dem::ClosureLaw<double> l = law(kClosure);
        for (const double p : {1e2, 1e5, 0.5e6, 1.25e6, 10e6, 20e6}) {
            const double w = exact_closure(kClosure, p);
            INFO("p " << p);
            CHECK(dem::pressure_of<kClosure>(l, w) == Approx(p).epsilon(1e-11).margin(1e-7));
            CHECK(dem::closure_at<kClosure>(l, p) == Approx(w).epsilon(1e-6).margin(1e-13));
            const double h = 1e-4 * (kMaximum - (kClosure == Closure::hyperbolic ? w : 0.0));
            CHECK(dem::tangent_at<kClosure>(l, p) ==
                  Approx((exact_pressure(kClosure, w + h) - exact_pressure(kClosure, w - h)) /
                         (2 * h))
                      .epsilon(1e-6));
            CHECK(dem::closing_energy<kClosure>(l, p, w) ==
                  Approx(exact_energy(kClosure, w)).epsilon(1e-6));
            const double root = dem::closed_by<kClosure>(l, w).root_ks(l);
            CHECK(root * root == Approx((kInitial + p / kMaximum) / 2.4).epsilon(1e-10));
        }
    });
}

TEST_CASE("closure: beyond the largest stiffness the law goes straight on", "[dem][closure]")
{
    for_both([]<Closure kClosure>() {
        const dem::ClosureLaw<double> l = law(kClosure, 0.0, 60e9);
        CHECK(exact_pressure(kClosure, l.knee) == Approx(l.knee_pressure));
        CHECK(dem::tangent_at<kClosure>(l, l.knee_pressure) == Approx(60e9));
        const double w = l.knee + 1e-4, p = l.knee_pressure + 60e9 * 1e-4;
        CHECK(dem::pressure_of<kClosure>(l, w) == Approx(p).epsilon(1e-12));
        CHECK(dem::closure_at<kClosure>(l, p) == Approx(w).epsilon(1e-9));
        CHECK(dem::tangent_at<kClosure>(l, p) == 60e9);
        CHECK(dem::closing_energy<kClosure>(l, p, w) ==
              Approx(exact_energy(kClosure, l.knee) + 0.5 * (l.knee_pressure + p) * 1e-4)
                  .epsilon(1e-7));
        const double root = dem::closed_by<kClosure>(l, w).root_ks(l);
        CHECK(root * root == Approx((kInitial + p / kMaximum) / 2.4).epsilon(1e-10));
    });
}

TEST_CASE("closure: one law has the wall moduli of the paper's Table 3", "[dem][closure]")
{
    constexpr double kHeight = 0.1, kStone = 15.5e9; // [m] [Pa]
    for (const auto& [stress, modulus] :
         {std::pair{0.15e6, 566e6}, std::pair{0.50e6, 768e6}, std::pair{1.00e6, 1057e6},
          std::pair{1.25e6, 1202e6}}) {
        const double w = dem::closure_at<Closure::hyperbolic>(law(Closure::hyperbolic), stress);
        const double wall = kHeight / (w / stress + kHeight / kStone);
        INFO("stress " << stress);
        CHECK(wall == Approx(modulus).epsilon(0.01));
    }
}

TEST_CASE("closure: a stack closes as its pressure says, from the first step", "[dem][closure]")
{
    const Closure closure = GENERATE(Closure::hyperbolic, Closure::exponential);
    const double stress = GENERATE(0.02, 0.5, 1.25, 20.0);
    const double loss = GENERATE(0.0, 0.3);
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.length = s.wall.unit_length = 0.2;
    s.wall.courses = 3;
    s.wall.bond_offset = 0.0;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.loads.height = 0.35;
    s.loads.vertical_stress = stress * 1e6;
    s.stone.poisson_ratio = s.beam.material.poisson_ratio = 0.0;
    s.stone.density = s.beam.material.density = 0.0;
    s.closure = closure;
    s.joint.closing = {kInitial, kMaximum, loss, 1e3 * kInitial};
    const dem::Model m = scenes::model_of(s);
    const dem::WallMaterials w = scenes::uniform(s, m);
    const dem::StepTables t = dem::step_tables(m);
    dem::SolverOptions options;
    dem::WallState<double> wall = dem::unloaded<double>(m, t, {&w, 1}, options);
    REQUIRE(dem::solve_preload(t, wall));
    double worst = 0.0;
    for (int k = 0; k < t.first_tied; ++k)
        worst =
            std::max(worst, std::abs(wall.u_n[k] / exact_closure(closure, stress * 1e6) + 1.0));
    CHECK(worst < 1e-10);
    const std::vector<double> at_rest = wall.q;
    for (int i = 0; i < 100; ++i) dem::step<double>(t, options, {}, wall);
    double moved = 0.0, size = 0.0;
    for (std::size_t i = 0; i < at_rest.size(); ++i) {
        moved = std::max(moved, std::abs(wall.q[i] - at_rest[i]));
        size = std::max(size, std::abs(at_rest[i]));
    }
    CHECK(moved < 1e-9 * size);
    CHECK(std::abs(dem::energy_of(t, wall, 0).residual()) < 1e-9);
}

TEST_CASE("closure: a wall is at rest from the first step however little its joints curve",
          "[dem][closure]")
{
    const Closure closure = GENERATE(Closure::hyperbolic, Closure::exponential);
    scenes::Scene s = closing_wall(closure);
    s.joint.closing.maximum = 30.0; // [m]
    s.crack.kn *= 300.0;
    s.crack.ks *= 300.0;
    const dem::Model m = small_wall::model(s);
    const dem::WallMaterials w = scenes::uniform(s, m);
    const dem::StepTables t = dem::step_tables(m);
    dem::WallState<double> wall = dem::unloaded<double>(m, t, {&w, 1}, {});
    CHECK(dem::solve_preload(t, wall));
    CHECK(wall.work > 0.0);
}

TEST_CASE("closure: a cycle loses the share that is asked for", "[dem][closure]")
{
    const double loss = GENERATE(0.0, 0.1, 0.3, 0.6, 0.9);
    for_both([&]<Closure kClosure>() {
        // Both laws are linear up to a small share of the maximum closure.
        for (const double w : {1e-4 * kMaximum, 0.6 * kMaximum}) {
            Contact<kClosure> c{law(kClosure, loss)};
            c.go(-w, 0.0, 4000);
            const double closing = c.work;
            CHECK(closing == Approx(exact_energy(kClosure, w)).epsilon(1e-3));
            c.go(0.0, 0.0, 4000);
            const double lost = c.work / closing;
            INFO("loss " << loss << " w/V " << w / kMaximum << " lost " << lost);
            CHECK(lost == Approx(loss).margin(w < 1e-3 * kMaximum ? 2e-3 : 0.1 * loss + 1e-6));
            CHECK(c.work == Approx(c.lost).epsilon(2e-3).margin(1e-9 * closing));
            CHECK(c.stored() == Approx(0.0).margin(1e-9 * closing));
            const double first = c.work;
            c.go(-w, 0.0, 4000);
            c.go(0.0, 0.0, 4000);
            CHECK(c.work - first ==
                  Approx(first).epsilon(1e-9).margin(1e-9 * closing)); // closed loops
        }
    });
}

TEST_CASE("closure: no path makes energy, and the ledger of each is closed", "[dem][closure]")
{
    const double loss = GENERATE(0.0, 0.3);
    const int path = GENERATE(range(0, 10));
    for_both([&]<Closure kClosure>() {
        std::mt19937_64 random(path);
        Contact<kClosure> c{law(kClosure, loss)};
        double most = 0.0;
        for (int leg = 0; leg < 12; ++leg) {
            const double w = std::max(-0.1, 0.8 * random_lanes::number(random)) * kMaximum;
            c.go(leg == 11 ? 1e-6 : -w, 2e-4 * random_lanes::number(random), 3000);
            most = std::max(most, c.stored());
            CHECK(c.work - c.lost == Approx(c.stored()).margin(2e-3 * most));
        }
        CHECK(c.least_loss > -1e-9 * most);
        CHECK(c.stored() == 0.0); // open at the end
        CHECK(c.work > 0.0);
        CHECK(most > 1.0);
    });
}

TEST_CASE("closure: pressure that goes up and down by a little leaves all as it was",
          "[dem][closure]")
{
    for_both([]<Closure kClosure>() {
        Contact<kClosure> c{law(kClosure, 0.3)};
        c.go(-0.5 * kMaximum, 1e-5, 2000);
        c.go(-0.495 * kMaximum, 0.0, 100);
        const double sigma = c.sigma, tau = c.tau, lost = c.lost;
        for (int i = 0; i < 1000; ++i) {
            c.go(-0.494 * kMaximum, 0.0, 4);
            c.go(-0.495 * kMaximum, 0.0, 4);
        }
        CHECK(c.sigma == Approx(sigma).epsilon(1e-9));
        CHECK(c.tau == Approx(tau).epsilon(1e-9));
        CHECK(c.lost == Approx(lost).epsilon(1e-12));
    });
}

TEST_CASE("closure: crushing stops where the pressure is the strength that is left",
          "[dem][closure]")
{
    const double energy = GENERATE(0.0, 2000.0);
    const dem::CrushingLaw<double> crushing = dem::crushing_law(1e10, 5e6, energy);
    for_both([&]<Closure kClosure>() {
        const dem::ClosureLaw<double> l = law(kClosure, 0.0, 1e12);
        const double w = exact_closure(kClosure, 5e6),
                     by = dem::crushed_by<kClosure>(crushing, l, 1e-5, -(w + 1e-6));
        CHECK(by > 0.0);
        CHECK(dem::pressure_of<kClosure>(l, w + 1e-6 - by) ==
              Approx(crushing.strength - crushing.softening * (1e-5 + by)).epsilon(1e-9));
        CHECK(dem::crushed_by<kClosure>(crushing, l, 0.0, -0.999 * w) == 0.0);
    });
}

TEST_CASE("closure: crushing stops there however far a step goes beyond", "[dem][closure]")
{
    const dem::CrushingLaw<double> crushing = dem::crushing_law(1e10, 0.1e6, 0.0);
    for_both([&]<Closure kClosure>() {
        const dem::ClosureLaw<double> l = law(kClosure);
        const double w = 2.0 * l.knee, by = dem::crushed_by<kClosure>(crushing, l, 0.0, -w);
        CHECK(dem::pressure_of<kClosure>(l, w - by) == Approx(0.1e6).epsilon(1e-6));
    });
}

TEST_CASE("closure: a contact that crushes at once gives back what it has stored",
          "[dem][closure]")
{
    const double loss = GENERATE(0.0, 0.4);
    for_both([&]<Closure kClosure>() {
        Contact<kClosure> c{law(kClosure, loss)};
        c.go(-0.7 * kMaximum, 0.0, 2000);
        const double stored = c.stored(), sigma = c.sigma;
        const auto before = c.state;
        const double by = 0.7 * kMaximum;
        const auto u = dem::advance_closing<kClosure, true>(c.law, kTanPhi, before, by, 0.0);
        CHECK(dem::work_of_crushing<kClosure>(c.law, before, sigma, by, u) ==
              Approx(stored).epsilon(1e-9));
        // A contact whose strength stays: pressure by what is crushed.
        const auto same =
            dem::advance_closing<kClosure, true>(c.law, kTanPhi, before, 0.0, 0.0);
        CHECK(dem::work_of_crushing<kClosure>(c.law, before, sigma, 1e-6, same) ==
              Approx(-1e-6 * sigma).epsilon(1e-9));
    });
}

TEST_CASE("closure: joints that close and crush keep the ledger", "[dem][closure]")
{
    const Closure closure = GENERATE(Closure::hyperbolic, Closure::exponential);
    const double energy = GENERATE(0.0, 2e4, 5.0); // the last breaks at once
    scenes::Scene s = closing_wall(closure, GENERATE(0.0, 0.5));
    s.joint.crushing = {energy == 5.0 ? 3e6 : 1.5e6, energy};
    dem::SolverOptions options = small_wall::quick();
    options.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    const dem::Model m = small_wall::model(s);
    const dem::PushResult r =
        dem::push(m, scenes::uniform(s, m), small_wall::to(0.0008), options);
    INFO("outcome " << static_cast<int>(r.outcome) << " residual " << r.residual << " crushing "
                    << r.energy.crushing << " of " << r.energy.passed());
    CHECK(r.step_reductions == 0);
    CHECK(r.residual < (energy == 5.0 ? 0.01 : 1e-4));
    CHECK(r.energy.crushing > (energy == 5.0 ? 0.0 : 0.2 * r.energy.passed()));
}

TEST_CASE("closure: the energy of joints that hardly curve is exact", "[dem][closure]")
{
    for (const double maximum : {1e-2, 1.0, 1e3}) { // [m]
        const double w = 2e-5, x = w / maximum;
        const auto l = [&](Closure closure) {
            return dem::closure_law(closure, kInitial, maximum, 1e3 * kInitial, 0.0, 0.4);
        };
        const auto of = [&]<Closure kClosure>() {
            const dem::ClosureLaw<double> one = l(kClosure);
            return dem::closing_energy<kClosure>(one, dem::pressure_of<kClosure>(one, w), w);
        };
        const double unit = kInitial * w * w;
        CHECK(of.operator()<Closure::hyperbolic>() ==
              Approx(unit * (0.5 + x / 3.0 + x * x / 4.0)).epsilon(1e-8));
        CHECK(of.operator()<Closure::exponential>() ==
              Approx(unit * (0.5 + x / 6.0 + x * x / 24.0)).epsilon(1e-8));
    }
}

TEST_CASE("closure: a joint that opens within a step makes no energy in the ledger",
          "[dem][closure]")
{
    for_both([]<Closure kClosure>() {
        Contact<kClosure> c{law(kClosure, 0.6)};
        c.go(-0.7 * kMaximum, 0.0, 2000);
        c.go(1e-6, 0.0, 1);
        CHECK(c.least_loss >= 0.0);
    });
}

namespace {

/// Straight on from the closure at which the tangent is 1000 k_0.
double straightened(Closure closure, double w)
{
    const double knee = closure == Closure::hyperbolic ? kMaximum * (1.0 - 1.0 / std::sqrt(1e3))
                                                       : kMaximum * std::log(1e3);
    const double within = std::min(w, knee);
    return exact_pressure(closure, within) + 1e3 * kInitial * (w - within);
}

/// Force on a rigid block of 1 m x 1 m on a joint, from its rotation: moment of the pressures
/// over the height.
double rocking_force(Closure closure, double load, double rotation)
{
    constexpr int kPoints = 20000;
    const auto sums = [&](double settled) {
        double n = 0.0, m = 0.0;
        for (int i = 0; i < kPoints; ++i) {
            const double x = (i + 0.5) / kPoints - 0.5;
            const double w = std::max(0.0, settled + rotation * x);
            const double p = straightened(closure, w) * 0.2 / kPoints;
            n += p;
            m += p * x;
        }
        return std::pair{n, m};
    };
    double low = -rotation, high = 10.0 * kMaximum; // of the middle
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (sums(middle).first < load ? low : high) = middle;
    }
    return sums(low).second;
}

} // namespace

TEST_CASE("closure: a rocking block on a joint that closes, against quadrature",
          "[dem][closure][slow]")
{
    const Closure closure = GENERATE(Closure::hyperbolic, Closure::exponential);
    const double to = GENERATE(0.2e-3, 0.6e-3);
    scenes::Scene s = scenes::monolith(1.0, 0.9, 1e6, 1e14);
    s.stone = {1e16, 0.0, 0.0};
    s.beam.material = s.stone;
    s.joint.tan_phi = 10.0;
    s.closure = closure;
    s.joint.closing = {kInitial, kMaximum, 0.0, 1e3 * kInitial};
    dem::Discretisation d;
    d.contact_points = 40;
    d.block_modes = d.beam_modes = 3;
    d.zones_per_interval = 1;
    d.face_rule = dem::FaceRule::even;
    const dem::Model m = scenes::model_of(s, d);
    dem::SolverOptions options;
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), small_wall::to(to), options);
    // The toe is held and the block is rigid: it turns by the displacement over the height.
    const dem::CurvePoint& end = r.curve.back();
    const double exact = rocking_force(closure, 0.2e6, end.displacement);
    INFO("at " << end.displacement << " force " << end.force << " exact " << exact);
    CHECK(end.force == Approx(exact).epsilon(0.005));
    CHECK(exact < 0.99 * 100e3); // the toe gives
    CHECK(r.residual < 1e-3);
}

TEST_CASE("closure: masses follow the stiffness, so that the step stays stable",
          "[dem][closure]")
{
    const Closure closure = GENERATE(Closure::hyperbolic, Closure::exponential);
    const scenes::Scene s = closing_wall(closure);
    const dem::Model m = small_wall::model(s);
    const dem::WallMaterials w = scenes::uniform(s, m);
    const dem::StepTables t = dem::step_tables(m);
    const dem::SolverOptions options;
    dem::WallState<double> wall = dem::unloaded<double>(m, t, {&w, 1}, options);
    const std::vector<double> first = wall.laws.inv_mass;
    REQUIRE(dem::solve_preload(t, wall));
    for (int i = 0; i < 6000; ++i) {
        dem::step<double>(t, options, {1.0, 5e-7, 1.0}, wall);
        if (i % 1000 == 999) {
            dem::WallState<double> now = wall;
            CHECK(dem::step_over_limit(t, now, options) < 1.0);
        }
    }
    CHECK(dem::energy_of(t, wall, 0).residual() == Approx(0.0).margin(2e-3));
    wall.laws.inv_mass = first;
    CHECK(dem::step_over_limit(t, wall, options) > 1.0);
}

TEST_CASE("closure: a joint without pressure gets the masses for its first stiffness",
          "[dem][closure]")
{
    scenes::Scene s = closing_wall(Closure::hyperbolic);
    s.joint.kn = 0.1 * kInitial; // from which the first masses are
    s.joint.ks = s.joint.kn / 2.4;
    const dem::Model m = small_wall::model(s);
    const dem::WallMaterials w = scenes::uniform(s, m);
    const dem::StepTables t = dem::step_tables(m);
    dem::WallState<double> wall = dem::unloaded<double>(m, t, {&w, 1}, {});
    dem::allow_for_run<Closure::hyperbolic>(t, 0, 0.0, wall);
    for (const int block : t.dry_blocks[0])
        if (block != dem::kGround) CHECK(wall.laws.ratio[block] >= 10.0);
}

TEST_CASE("closure: the same bits alone and in any lane", "[dem][closure]")
{
    const Closure closure = GENERATE(Closure::hyperbolic, Closure::exponential);
    const scenes::Scene s = closing_wall(closure);
    const dem::Model m = small_wall::model(s);
    dem::SolverOptions options = small_wall::quick();
    options.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    dem::PushPlan plan;
    plan.targets = {0.0015, -0.0005, 0.0};
    std::vector<dem::WallMaterials> walls;
    for (std::size_t i = 0; i < dem::lanes<dem::Pack> + 1; ++i) {
        walls.push_back(scenes::table5_sample(s, m, i));
        for (dem::JointMaterial& j : walls.back().joints) {
            j.closing.maximum *= 1.0 + 0.05 * static_cast<double>(i);
            if (i % 3 != 0) j.closing.loss = 0.1 * static_cast<double>(i % 5);
        }
    }
    std::vector<dem::PushResult> together(walls.size());
    dem::Ensemble e;
    e.size = walls.size();
    e.wall = [&](std::size_t i) { return walls.at(i); };
    e.done = [&](std::size_t i, dem::PushResult&& r) { together[i] = std::move(r); };
    dem::push_ensemble(m, e, plan, options, {.threads = 1});
    for (std::size_t i = 0; i < walls.size(); ++i) {
        INFO("wall " << i);
        CHECK(small_wall::same(dem::push(m, walls[i], plan, options), together[i]));
        CHECK(together[i].residual < 0.01);
        CHECK(together[i].outcome == dem::Outcome::reached_target);
    }
}

TEST_CASE("closure: numbers out of range are refused, and mortar is", "[dem][closure]")
{
    scenes::Scene s = closing_wall(Closure::hyperbolic);
    dem::Model m = small_wall::model(s);
    dem::WallMaterials w = scenes::uniform(s, m);
    CHECK_NOTHROW(dem::check(m, w));
    const auto refused = [&](dem::Closing closing) {
        dem::WallMaterials wrong = w;
        wrong.joints.front().closing = closing;
        CHECK_THROWS_AS(dem::check(m, wrong), std::invalid_argument);
    };
    refused({0.0, kMaximum, 0.0, 1e12});
    refused({kInitial, 0.0, 0.0, 1e12});
    refused({kInitial, kMaximum, 1.0, 1e12});
    refused({kInitial, kMaximum, -0.1, 1e12});
    refused({kInitial, kMaximum, 0.0, 1e9});
    refused({kInitial, kMaximum, 0.0, 1e16});
    m.layout.mortar = true;
    CHECK_THROWS_AS(dem::check(m, w), std::invalid_argument);
}

TEST_CASE("closure: where nothing slips or opens, all that joints lose is lost as they close",
          "[dem][closure]")
{
    const Closure closure = GENERATE(Closure::hyperbolic, Closure::exponential);
    const bool finite = GENERATE(false, true);
    const double loss = GENERATE(0.0, 0.3);
    scenes::Scene s = closing_wall(closure, loss);
    s.joint.tan_phi = 1e3;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    const dem::Model m = small_wall::model(s);
    dem::SolverOptions o;
    if (finite) o.kinematics = dem::Kinematics::finite;
    dem::PushPlan plan = small_wall::to(2e-5);
    plan.targets = {2e-5, 0.0};
    plan.record_every = 2e-6;
    const dem::Energy e = dem::push(m, scenes::uniform(s, m), plan, o).energy;
    INFO("friction " << e.friction << " closing " << e.closing);
    if (loss == 0.0) {
        CHECK(e.closing == 0.0);
        return;
    }
    // where a contact is pressed less, its shear gives a little to friction
    CHECK(e.closing <= (1.0 + 1e-9) * e.friction);
    CHECK(e.closing > 0.99 * e.friction);
    CHECK(e.friction > 1e-3 * e.elastic);
}
