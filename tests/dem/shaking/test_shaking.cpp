/// Blocks on ground that moves, against closed forms (docs/dynamics.md has the sources).

#include "dem/solver/push.hpp"
#include "tests/dem/shaken_blocks.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace shaken_blocks;

namespace {

/// First time at which the top passes its place [s], by interpolation.
double first_zero(const dem::ShakeResult& r)
{
    for (std::size_t i = 1; i < r.history.size(); ++i) {
        const auto &a = r.history[i - 1], &b = r.history[i];
        if (a.displacement * b.displacement <= 0.0)
            return a.time +
                   (b.time - a.time) * a.displacement / (a.displacement - b.displacement);
    }
    return 0.0;
}

dem::ShakePlan release(double b, double h, double th, double time)
{
    dem::ShakePlan p;
    p.step = 0.01;
    p.horizontal = {0.0, 0.0};
    p.released = {turned(0, b, h, th)};
    p.free_vibration = time;
    p.record_every = 1e-4;
    return p;
}

/// A block that slides on one that the ground holds.
scenes::Scene on_a_held_block(double b, double h, double kn, double tan_phi)
{
    scenes::Scene s = block(b, h, kn, tan_phi);
    s.wall.courses = 2;
    s.wall.course_height = 2.0 * h;
    s.wall.bond_offset = 0.0;
    s.wall.base = dem::Base::fixed;
    return s;
}

/// Displacement of a block under body forces of this load factor [m], by pushing it.
double pushed_to(const dem::Model& m, const dem::WallMaterials& w, double factor)
{
    dem::PushPlan plan;
    plan.targets = {0.004};
    plan.record_every = 1e-5;
    dem::SolverOptions options;
    options.kinematics = dem::Kinematics::finite;
    options.accuracy = 1e-3;
    const dem::PushResult r = dem::push(m, w, plan, options);
    for (std::size_t i = 1; i < r.curve.size(); ++i) {
        const double a = r.curve[i - 1].force / r.weight, b = r.curve[i].force / r.weight;
        if (a < factor && b >= factor)
            return r.curve[i - 1].displacement +
                   (factor - a) / (b - a) *
                       (r.curve[i].displacement - r.curve[i - 1].displacement);
    }
    return NAN;
}

struct Toe {
    const char* name;
    dem::Closure closure;
    double loss, strength; ///< of closing [-], compressive [Pa]
    double factor;         ///< load factor to compare at [-]
};

scenes::Scene on_toe(const Toe& toe)
{
    scenes::Scene s = block(0.25, 1.0, 1e9);
    if (toe.closure != dem::Closure::linear) {
        s.closure = toe.closure;
        s.joint.closing = {1e8, 2e-4, toe.loss, 1e10};
        s.joint.kn = 1e8 + 45e3 / 2e-4;
    }
    s.joint.ks = 0.4 * s.joint.kn;
    if (toe.strength > 0.0) s.joint.crushing = {toe.strength, 0.0};
    return s;
}

} // namespace

TEST_CASE("shaking: a rigid block that is let go takes the quarter period of Housner's block",
          "[dem][shaking]")
{
    struct Case {
        double b, h, phi, quarter; // p T / 4
    };
    const auto c = GENERATE(values<Case>({{0.25, 1.0, 0.2, 0.695569},
                                          {0.25, 1.0, 0.5, 1.319279},
                                          {0.25, 1.0, 0.9, 2.994580},
                                          {0.5, 1.0, 0.5, 1.325310},
                                          {0.5, 0.55, 0.5, 1.338304}}));
    const double alpha = std::atan(c.b / c.h),
                 p = std::sqrt(0.75 * kGravity / std::hypot(c.b, c.h));
    const auto r =
        shaken(block(c.b, c.h), release(c.b, c.h, c.phi * alpha, 1.1 * c.quarter / p));
    INFO("phi " << c.phi << " step " << r.time_step << " ledger " << r.residual);
    CHECK(r.outcome == dem::ShakeOutcome::stood);
    CHECK(first_zero(r) == Approx(c.quarter / p).epsilon(5e-3));
    CHECK(r.residual < 0.01);
}

TEST_CASE("shaking: half a sine overturns a rigid block at the exact peak", "[dem][shaking]")
{
    struct Case {
        double b, h, ratio, peak; // omega / p, a / (g tan alpha)
    };
    const auto c = GENERATE(values<Case>({{0.25, 1.0, 1.0, 1.32131},
                                          {0.25, 1.0, 3.0, 2.29728},
                                          {0.25, 1.0, 6.0, 3.80131},
                                          {0.5, 1.5, 4.0, 2.80185},
                                          {0.5, 0.55, 3.0, 2.31617}}));
    const double p = std::sqrt(0.75 * kGravity / std::hypot(c.b, c.h));
    const double exact = c.peak * kGravity * c.b / c.h;
    const auto falls = [&](double share) {
        dem::ShakePlan plan = half_sine(share * exact, std::numbers::pi / (c.ratio * p));
        plan.free_vibration = 16.0 / p; // one in a hundred from the edge takes its time
        const auto r = shaken(block(c.b, c.h), plan);
        INFO(share << " " << dem::name_of(r.outcome) << " ledger " << r.residual);
        CHECK(r.residual < 0.01);
        return r.outcome == dem::ShakeOutcome::collapsed;
    };
    INFO("b " << c.b << " h " << c.h << " omega/p " << c.ratio);
    CHECK(falls(1.01));
    CHECK_FALSE(falls(0.99));
}

TEST_CASE("shaking: a block slides as far as Newmark's under half a sine and a rectangle",
          "[dem][shaking]")
{
    const double peak = kGravity, duration = 0.25, omega = std::numbers::pi / duration;
    struct Case {
        double mu, way; // in A / omega^2
    };
    const auto c = GENERATE(
        values<Case>({{0.1, 16.958449}, {0.2, 7.058745}, {0.3, 3.826231}, {0.5, 1.364057}}));
    dem::ShakePlan plan = half_sine(peak, duration);
    plan.free_vibration = 3.0;
    plan.contact_damping = 0.1;
    const auto r = shaken(block(2.0, 0.25, 1e10, c.mu), plan);
    INFO("mu " << c.mu << " " << dem::name_of(r.outcome) << " ledger " << r.residual);
    CHECK(r.outcome == dem::ShakeOutcome::stood);
    CHECK(-r.residual_displacement == Approx(c.way * peak / (omega * omega)).epsilon(0.01));
}

TEST_CASE(
    "shaking: ground that accelerates upwards presses a block down, downwards it frees it",
    "[dem][shaking]")
{
    const double peak = kGravity, duration = 0.25, omega = std::numbers::pi / duration;
    struct Case {
        double vertical, way; // g; A / omega^2 at friction of 0.2 (1 + vertical)
    };
    const auto c = GENERATE(values<Case>({{0.5, 3.826231}, {-0.5, 16.958449}}));
    dem::ShakePlan plan = half_sine(peak, duration);
    constexpr std::size_t kRise = 400; // samples before the pulse
    plan.horizontal.insert(plan.horizontal.begin(), kRise, 0.0);
    plan.horizontal.resize(plan.horizontal.size() + 3000, 0.0);
    for (std::size_t i = 0; i < plan.horizontal.size(); ++i)
        plan.vertical.push_back(c.vertical * kGravity *
                                std::min(1.0, static_cast<double>(i) / kRise));
    plan.free_vibration = 0.1;
    plan.contact_damping = 0.1;
    const auto r = shaken(block(2.0, 0.25, 1e10, 0.2), plan);
    INFO("vertical " << c.vertical << " g, ledger " << r.residual);
    CHECK(-r.residual_displacement == Approx(c.way * peak / (omega * omega)).epsilon(0.01));
    CHECK(r.residual < 0.01);
}

TEST_CASE("shaking: a block on ground that swings slides the way of each half cycle",
          "[dem][shaking]")
{
    struct Case {
        double mu, peak, frequency, way; // m/s2, Hz, mm
    };
    const auto c = GENERATE(values<Case>({{0.62, 9.81, 2.0, 43.972893},
                                          {0.3, 9.81, 2.0, 109.584877},
                                          {0.2, 3.0, 1.0, 44.213006}}));
    dem::ShakePlan plan;
    plan.step = 1e-3 / c.frequency;
    for (int i = 0; i <= 6000; ++i)
        plan.horizontal.push_back(
            c.peak * std::sin(2.0 * std::numbers::pi * c.frequency * i * plan.step));
    plan.free_vibration = 0.0;
    plan.record_every = plan.step;
    plan.contact_damping = 0.1;
    const auto r = shaken(block(2.0, 0.25, 1e10, c.mu), plan);
    double least = 1e9, most = -1e9; // in the last cycle
    for (std::size_t i = 5000; i < r.history.size(); ++i) {
        least = std::min(least, r.history[i].displacement);
        most = std::max(most, r.history[i].displacement);
    }
    INFO("mu " << c.mu << " ledger " << r.residual);
    CHECK(1e3 * (most - least) == Approx(c.way).epsilon(0.01));
}

TEST_CASE("shaking: two stacked blocks move as Lagrange's equations say until they strike",
          "[dem][shaking]")
{
    scenes::Scene s = block(0.25, 0.5, 1e11, 10.0);
    s.wall.courses = 2;
    s.wall.course_height = 1.0;
    s.wall.bond_offset = 0.0;
    const dem::Model m = model(s);
    struct Case {
        double first, second, then_first, then_second;
    };
    const auto c = GENERATE(
        values<Case>({{0.05, 0.15, 0.0506772, 0.1440599}, {0.08, 0.10, 0.0817083, 0.0920602}}));
    dem::ShakePlan plan;
    plan.step = 0.01;
    plan.horizontal = {0.0, 0.0};
    plan.free_vibration = 0.04; // 0.05 s in all
    const dem::Displaced lower = turned(0, 0.25, 0.5, c.first);
    dem::Displaced upper = turned(1, 0.25, 0.5, c.second);
    // Its corner stands on the right upper corner of the lower one.
    upper.x += std::sin(c.first);
    upper.z += std::cos(c.first) - 1.0;
    plan.released = {lower, upper};
    const auto r = dem::shake(m, scenes::uniform(s, m), plan);
    const auto rotation = [&](int b) {
        const dem::BlockState& k = r.at_end.blocks[b];
        const dem::Point p{k.outline[1].x - k.outline[0].x, k.outline[1].z - k.outline[0].z};
        const dem::Point q{p.x + k.displacement[1].x - k.displacement[0].x,
                           p.z + k.displacement[1].z - k.displacement[0].z};
        return std::atan2(p.z, p.x) - std::atan2(q.z, q.x);
    };
    INFO(dem::name_of(r.outcome) << " ledger " << r.residual << " step " << r.time_step);
    CHECK(r.end == Approx(0.05));
    CHECK(rotation(0) - c.first == Approx(c.then_first - c.first).epsilon(0.01));
    CHECK(rotation(1) - c.second == Approx(c.then_second - c.second).epsilon(0.01));
}

TEST_CASE("shaking: a wall under a floor lifts at half a g, one under a jack at sixteen",
          "[dem][shaking]")
{
    struct Case {
        double load; // kN
        dem::LoadMass mass;
        double uplift; // g
    };
    const auto c = GENERATE(values<Case>({{0.0, dem::LoadMass::floor, 0.9091},
                                          {30.0, dem::LoadMass::floor, 0.4959},
                                          {100.0, dem::LoadMass::floor, 0.4678},
                                          {250.0, dem::LoadMass::floor, 0.4599},
                                          {100.0, dem::LoadMass::none, 16.0606}}));
    // A block of 1 m x 1.1 m, whose uppermost tenth is the beam that is tied to it.
    scenes::Scene s = scenes::monolith(1.0, 0.99, c.load * 1e3 / 0.2, 1e10);
    s.wall.toe = dem::Toe::free;
    s.beam.height = 0.11;
    s.loads.height = 1.1;
    s.stone = {1e16, 0.0, 6e3 / (kGravity * 0.2 * 1.1)};
    s.beam.material = s.stone;
    s.joint.tan_phi = 100.0;
    s.loads.pattern = dem::LoadPattern::body;
    const auto lifts = [&](double share) {
        dem::ShakePlan p;
        p.step = 2.0;
        p.horizontal = {0.0, share * c.uplift * kGravity, share * c.uplift * kGravity};
        p.load = c.mass;
        p.free_vibration = 0.0;
        p.contact_damping = 0.5;
        const auto r = shaken(s, p);
        INFO(dem::name_of(r.outcome) << " " << r.unbalance << " ledger " << r.residual);
        CHECK((r.outcome == dem::ShakeOutcome::stood || share > 1.0));
        CHECK(r.unbalance <= 1e-6);
        CHECK((share > 1.0 ? r.uplift >= 0.5 : r.uplift == 0.0)); // one end of two, or both
        return r.last_opening > 0.0;
    };
    INFO("load " << c.load);
    CHECK(lifts(1.01));
    CHECK_FALSE(lifts(0.99));
}

TEST_CASE("shaking: contact damping takes the share zeta of a vertical swing", "[dem][shaking]")
{
    const double kn = 1e8, zeta = GENERATE(0.0, 0.02, 0.05), mass = 2300.0 * 2.0 * 0.5 * 0.2;
    const double omega = std::sqrt(kn * 2.0 * 0.2 / mass), rest = mass * kGravity / (kn * 0.4);
    dem::ShakePlan plan;
    plan.step = 0.01;
    plan.horizontal = {0.0, 0.0};
    // Half as deep again as its weight presses it: it swings without opening.
    plan.released = {{0, 0.0, -1.5 * rest, 0.0}};
    const double period = 2.0 * std::numbers::pi / omega;
    plan.free_vibration = 6.0 * period;
    plan.step_fraction = 0.02;
    plan.snapshot_every = period / 200.0;
    plan.contact_damping = zeta;
    const auto r = shaken(block(1.0, 0.25, kn), plan);
    std::vector<double> peaks; // of the distance below the place of rest
    for (std::size_t i = 1; i + 1 < r.snapshots.size(); ++i) {
        const auto depth = [&](std::size_t j) {
            return -r.snapshots[j].blocks[0].displacement[0].z - rest;
        };
        if (depth(i) >= depth(i - 1) && depth(i) > depth(i + 1)) peaks.push_back(depth(i));
    }
    REQUIRE(peaks.size() >= 5);
    const double decay =
        std::exp(-2.0 * std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta));
    INFO("zeta " << zeta << " ledger " << r.residual << " step " << r.time_step << " omega "
                 << omega);
    CHECK(peaks[4] / peaks[0] == Approx(std::pow(decay, 4)).epsilon(0.01));
    CHECK(r.residual < 0.01);
}

TEST_CASE("shaking: two corners with strong dashpots lose what Housner's block loses",
          "[dem][shaking]")
{
    const auto [b, h, energy] =
        GENERATE(values<std::array<double, 3>>({{0.25, 1.0, 0.831315}, {0.5, 1.0, 0.49}}));
    const double alpha = std::atan(b / h), th = 0.5 * alpha;
    const double p = std::sqrt(0.75 * kGravity / std::hypot(b, h));
    dem::ShakePlan plan = release(b, h, th, 3.2 / p);
    plan.contact_damping = 2.0;
    plan.step_fraction = 0.1;
    const auto r = shaken(block(b, h, 1e9), plan);
    double other = 0.0; // farthest on the other side of the middle
    for (const auto& point : r.history) other = std::min(other, point.displacement);
    // Displacement of the middle of a block that has turned by t: b - R sin(alpha - t).
    const double radius = std::hypot(b, h), t = alpha - std::asin((b + other) / radius);
    const double found =
        (std::cos(alpha - t) - std::cos(alpha)) / (std::cos(alpha - th) - std::cos(alpha));
    INFO("b " << b << " ledger " << r.residual << " step " << r.time_step << " rotation " << t);
    CHECK(std::sqrt(found) == Approx(std::sqrt(energy)).epsilon(0.01));
    CHECK(r.residual < 0.01);
}

TEST_CASE("shaking: an undamped block rocks for seconds and keeps its energy", "[dem][shaking]")
{
    const double th = 0.5 * std::atan(0.25);
    const auto r = shaken(block(0.25, 1.0), release(0.25, 1.0, th, 5.0));
    CHECK(r.outcome == dem::ShakeOutcome::stood);
    CHECK(r.step_reductions <= 1); // the moment of an impact is missed by up to a step
    CHECK(r.residual < 0.01);
}

TEST_CASE("shaking: a wall whose top hardly moves any more is not followed further",
          "[dem][shaking]")
{
    // It swings up and down for ever, and its top stays above its foot.
    const double kn = 1e8, rest = 2300.0 * 0.5 * kGravity / kn;
    dem::ShakePlan plan;
    plan.step = 0.01;
    plan.horizontal = {0.0, 0.0};
    plan.released = {{0, 0.0, -1.5 * rest, 0.0}};
    plan.free_vibration = 1.0;
    const double whole = shaken(block(1.0, 0.25, kn), plan).end;
    plan.quiet = 1e-4;
    CHECK(whole == Approx(1.01).epsilon(1e-3));
    CHECK(shaken(block(1.0, 0.25, kn), plan).end == Approx(0.01 + 0.2).epsilon(0.01));
    dem::ShakePlan rocks = release(0.25, 1.0, 0.1, 1.0);
    rocks.quiet = 1e-4;
    CHECK(shaken(block(0.25, 1.0), rocks).end == Approx(1.01).epsilon(1e-3));
}

TEST_CASE("shaking: a block that slides far loses mu N times its way, on the ground and where "
          "its face shrinks",
          "[dem][shaking]")
{
    const bool shrinks = GENERATE(false, true);
    const double mu = 0.15, mass = 2300.0 * 2.0 * 0.5 * 0.2;
    dem::ShakePlan plan = half_sine(kGravity, 0.2);
    plan.free_vibration = 3.0;
    plan.contact_damping = 0.1;
    const auto r = shaken(
        shrinks ? on_a_held_block(1.0, 0.25, 1e10, mu) : block(1.0, 0.25, 1e10, mu), plan);
    const double way = std::abs(r.residual_displacement);
    INFO("shrinks " << shrinks << " way " << way << " ledger " << r.residual);
    CHECK(r.outcome == dem::ShakeOutcome::stood);
    CHECK(way > 0.3);
    CHECK(r.energy.friction == Approx(mu * mass * kGravity * way).epsilon(1e-3));
    CHECK(r.residual < 1e-4);
}

TEST_CASE("shaking: a block that a corner throws off at a large angle has the energy that the "
          "corner stored",
          "[dem][shaking]")
{
    // Turned by a third of a radian, pressed into the block below with its lower right corner.
    const scenes::Scene s = on_a_held_block(0.5, 0.25, 1e8, 0.6);
    dem::ShakePlan plan;
    plan.step = 0.01;
    plan.horizontal = {0.0, 0.0};
    plan.free_vibration = 0.05;
    plan.released = {turned(1, 0.5, 0.25, 0.35)};
    plan.released.front().x -= 0.05;
    plan.released.front().z -= 0.005;
    plan.step_fraction = 0.05;
    const dem::Model m = model(s);
    const auto r = dem::shake(m, scenes::uniform(s, m), plan);
    INFO("ledger " << r.residual << " step " << r.time_step << " kinetic " << r.energy.kinetic);
    CHECK(r.step_reductions == 0);
    CHECK(r.energy.elastic == 0.0);
    CHECK(r.residual < 1.5e-3);
}

TEST_CASE("shaking: the paper's wall under a floor is shaken and keeps its energy balance",
          "[dem][shaking]")
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.loads.pattern = dem::LoadPattern::body;
    s.wall.toe = dem::Toe::free;
    const dem::Model m = scenes::model_of(s, dem::discretisation_of(dem::Fidelity::simple));
    dem::ShakePlan plan = half_sine(0.6 * kGravity, 0.2, 40);
    plan.load = dem::LoadMass::floor;
    plan.free_vibration = 0.2;
    const auto r = dem::shake(m, scenes::uniform(s, m), plan);
    INFO(dem::name_of(r.outcome) << " ledger " << r.residual << " unbalance " << r.unbalance);
    CHECK(r.outcome == dem::ShakeOutcome::stood);
    CHECK(r.unbalance <= 1e-6);
    CHECK(r.step_reductions == 0);
    CHECK(r.residual < 0.01);
    CHECK(r.energy.friction > 0.5 * r.ground_work); // it slides more than it rocks
}

TEST_CASE("shaking: ground that accelerates slowly pulls the whole mass along",
          "[dem][shaking]")
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.loads.pattern = dem::LoadPattern::body;
    s.wall.toe = dem::Toe::free;
    const dem::Model m = scenes::model_of(s, rigid(3));
    double mass = 0.0; // with the blocks that the ground holds
    for (std::size_t i = 0; i < m.layout.blocks.size(); ++i) {
        const dem::Block& b = m.layout.blocks[i];
        const bool beam = static_cast<int>(i) == m.layout.beam;
        mass += (beam ? s.beam.material.density : s.stone.density) * (b.x1 - b.x0) *
                (b.z1 - b.z0) * m.layout.thickness;
    }
    dem::ShakePlan plan; // a ramp to 0.05 g in a second, some forty periods of the wall
    plan.step = 0.01;
    plan.free_vibration = 0.0;
    for (int i = 0; i <= 100; ++i) plan.horizontal.push_back(5e-4 * kGravity * i);
    const auto r = dem::shake(m, scenes::uniform(s, m), plan);
    REQUIRE(r.outcome == dem::ShakeOutcome::stood);
    CHECK(r.history.back().base_shear == Approx(-mass * 0.05 * kGravity).epsilon(0.02));
}

TEST_CASE("shaking: ground that accelerates slowly turns a block as far as body forces do, "
          "whatever its toe",
          "[dem][shaking]")
{
    const Toe toe = GENERATE(
        values<Toe>({{"elastic", dem::Closure::linear, 0.0, 0.0, 0.2},
                     {"crushes", dem::Closure::linear, 0.0, 0.15e6, 0.165},
                     {"exponential", dem::Closure::exponential, 0.0, 0.0, 0.2},
                     {"hyperbolic, loses", dem::Closure::hyperbolic, 0.3, 0.0, 0.2},
                     {"exponential, crushes", dem::Closure::exponential, 0.0, 0.15e6, 0.165}}));
    const scenes::Scene s = on_toe(toe);
    const dem::Model m = scenes::model_of(s, rigid(9));
    const dem::WallMaterials w = scenes::uniform(s, m);
    dem::ShakePlan plan;
    plan.step = 0.01;
    for (int i = 0; i <= 2000; ++i)
        plan.horizontal.push_back(-toe.factor * kGravity * i / 2000.0);
    plan.free_vibration = 0.0;
    const dem::ShakeResult r = dem::shake(m, w, plan);
    INFO(toe.name << " ledger " << r.residual << " reductions " << r.step_reductions << " "
                  << dem::name_of(r.outcome));
    REQUIRE(r.outcome == dem::ShakeOutcome::stood);
    CHECK(r.residual < 0.01);
    const auto& last = r.history.back();
    CHECK(last.displacement == Approx(pushed_to(m, w, -last.ground / kGravity)).epsilon(0.02));
    CHECK((r.energy.crushing > 0.0) == (toe.strength > 0.0));
}

TEST_CASE("shaking: a block on a joint that closes swings with its tangent", "[dem][shaking]")
{
    const double k0 = 1e8, v = 1e-4, mass = 2300.0 * 2.0 * 0.5 * 0.2;
    const double p = mass * kGravity / 0.4, tangent = k0 + p / v;
    const double omega = std::sqrt(tangent * 0.4 / mass),
                 period = 2.0 * std::numbers::pi / omega;
    scenes::Scene s = block(1.0, 0.25, tangent);
    s.closure = dem::Closure::exponential;
    s.joint.closing = {k0, v, 0.0, 1e3 * k0};
    s.joint.ks = 0.4 * tangent;
    const double rest = v * std::log1p(p / (k0 * v));
    dem::ShakePlan plan;
    plan.step = 0.01;
    plan.horizontal = {0.0, 0.0};
    plan.released = {{0, 0.0, -1.02 * rest, 0.0}};
    plan.free_vibration = 6.0 * period;
    plan.snapshot_every = period / 400.0;
    const dem::Model m = scenes::model_of(s, rigid());
    const auto r = dem::shake(m, scenes::uniform(s, m), plan);
    std::vector<double> times; // at which it passes its place of rest, downwards
    for (std::size_t i = 1; i < r.snapshots.size(); ++i) {
        const auto at = [&](std::size_t j) {
            return r.snapshots[j].blocks[0].displacement[0].z + rest;
        };
        if (at(i - 1) > 0.0 && at(i) <= 0.0)
            times.push_back(r.snapshot_times[i - 1] +
                            at(i - 1) / (at(i - 1) - at(i)) *
                                (r.snapshot_times[i] - r.snapshot_times[i - 1]));
    }
    REQUIRE(times.size() >= 5);
    CHECK((times[4] - times[0]) / 4.0 == Approx(period).epsilon(5e-3));
    CHECK(r.residual < 0.01);
}

TEST_CASE("shaking: the paper's wall with joints that close and toes that crush keeps its "
          "energy balance",
          "[dem][shaking]")
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.loads.pattern = dem::LoadPattern::body;
    s.wall.toe = dem::Toe::free;
    s.closure = dem::Closure::exponential;
    s.joint.closing = {4.87e9, 1.54e-4, 0.1, 100.0 * 4.87e9};
    s.joint.crushing = {6e6, 25e3};
    const dem::Model m = scenes::model_of(s, dem::discretisation_of(dem::Fidelity::simple));
    dem::ShakePlan plan = half_sine(0.6 * kGravity, 0.2, 40);
    plan.load = dem::LoadMass::floor;
    plan.free_vibration = 0.1;
    const auto r = dem::shake(m, scenes::uniform(s, m), plan);
    INFO(dem::name_of(r.outcome) << " ledger " << r.residual << " reductions "
                                 << r.step_reductions << " step " << r.time_step);
    CHECK(r.outcome == dem::ShakeOutcome::stood);
    CHECK(r.residual < 0.01);
    CHECK(r.energy.crushing > 0.0);
}

TEST_CASE("shaking: a block on corners that become a hundred times stiffer keeps its energy",
          "[dem][shaking]")
{
    // It rocks on its corners, which close to a hundred times their stiffness at rest.
    const double b = 0.25, h = 1.0, k0 = 1e9, v = 1e-5, rest = 2300.0 * 2.0 * h * kGravity;
    scenes::Scene s = block(b, h, k0 + rest / v);
    s.closure = dem::Closure::hyperbolic;
    s.joint.closing = {k0, v, 0.0, 1e3 * k0};
    s.joint.ks = 0.4 * s.joint.kn;
    const dem::Model m = scenes::model_of(s, rigid());
    dem::ShakePlan plan = release(b, h, 0.3 * std::atan(b / h), 1.5);
    plan.snapshot_every = 1e-3;
    const auto r = dem::shake(m, scenes::uniform(s, m), plan);
    double pressure = 0.0;
    for (const dem::Snapshot& at : r.snapshots)
        for (const dem::FaceState& f : at.faces)
            for (const dem::ContactState& c : f.contacts)
                pressure = std::max(pressure, -c.sigma);
    const double secant = 1.0 + pressure / (k0 * v);
    const double stiffest = std::min(1e3 * k0, k0 * secant * secant);
    const double mass = 2300.0 * 2.0 * b * 2.0 * h * 0.2, area = 2.0 * b * 0.2;
    INFO("step " << r.time_step << " reductions " << r.step_reductions << " pressure "
                 << pressure << " stiffer by " << stiffest / s.joint.kn << " "
                 << dem::name_of(r.outcome) << " ledger " << r.residual);
    CHECK(stiffest > 20.0 * s.joint.kn);
    CHECK(r.outcome == dem::ShakeOutcome::stood);
    CHECK(r.residual < 0.01);
    CHECK(r.time_step <= 0.2 * 2.0 * std::sqrt(mass / (stiffest * area)));
}

TEST_CASE("shaking: what cannot be shaken is refused in words", "[dem][shaking]")
{
    const auto refused = [](const scenes::Scene& s, const char* word) {
        dem::ShakePlan plan = half_sine(1.0, 0.1, 10);
        const dem::Model m = scenes::model_of(s, rigid());
        CHECK_THROWS_WITH(dem::shake(m, scenes::uniform(s, m), plan),
                          Catch::Matchers::Contains(word));
    };
    const scenes::Scene good = block(0.25, 1.0);
    scenes::Scene s = good;
    s.wall.toe = dem::Toe::held;
    refused(s, "leave the toe free");
    s = scenes::paper_wall(0.50);
    refused(s, "body forces");
    s = on_toe({"", dem::Closure::exponential, 0.0, 0.0, 0.0});
    const dem::Model closes = scenes::model_of(s, rigid());
    dem::ShakePlan damped = half_sine(1.0, 0.1, 10);
    damped.contact_damping = 0.05;
    CHECK_THROWS_WITH(dem::shake(closes, scenes::uniform(s, closes), damped),
                      Catch::Matchers::Contains("joints that close have no dashpots"));
    const dem::Model m = model(good);
    dem::ShakePlan plan = half_sine(1.0, 0.1, 10);
    plan.horizontal[3] = NAN;
    CHECK_THROWS_WITH(dem::shake(m, scenes::uniform(good, m), plan),
                      Catch::Matchers::Contains("finite"));
    plan = half_sine(1.0, 0.1, 10);
    plan.vertical = {0.0};
    CHECK_THROWS_WITH(dem::shake(m, scenes::uniform(good, m), plan),
                      Catch::Matchers::Contains("as many samples"));
}
