/// Walls of several blocks with finite displacements.

#include "dem/block/model.hpp"
#include "dem/kinematics/overlap.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/step/finite_step.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

/// A clamped block and n more on it, 0.2 m long, each a share of its harmonic place further out
/// than the one under it; the beam hangs out of reach. The largest rotation after a while.
double largest_turn(int n, double share)
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.length = s.wall.unit_length = 0.2;
    s.wall.courses = n + 1;
    s.wall.bond_offset = 0.0;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.beam.interface = dem::BeamInterface::joint;
    s.beam.material.density = 0.0;
    s.loads.vertical_stress = 0.0;
    s.loads.height = (n + 1) * s.wall.course_height;
    s.joint.kn *= 100.0;
    s.joint.ks *= 100.0;
    dem::Discretisation d;
    d.block_modes = d.beam_modes = 3;
    const dem::Model m = scenes::model_of(s, d);
    const dem::StepTables t = dem::step_tables(m);
    const dem::WallMaterials w = scenes::uniform(s, m);
    dem::SolverOptions o;
    o.kinematics = dem::Kinematics::finite;
    auto state = dem::unloaded<double>(m, t, {&w, 1}, o);
    double out = 0.0;
    for (int block = 1; block <= n; ++block) {
        out += share * 0.1 / (n + 1 - block);
        state.finite.frames[block].x += out;
    }
    state.finite.frames[m.layout.beam].z += 1.0;
    dem::take_up_frames(t, o, state);
    double turn = 0.0;
    for (int i = 0; i < 60000 && turn < 0.3; ++i) {
        dem::step(t, o, dem::StepInput<double>{1.0, 0.0}, state);
        for (const auto& f : state.finite.frames) turn = std::max(turn, std::abs(f.turn));
    }
    return turn;
}

dem::SolverOptions finite()
{
    dem::SolverOptions o = small_wall::quick();
    o.kinematics = dem::Kinematics::finite;
    return o;
}

} // namespace

TEST_CASE(
    "finite wall: one block tips over an edge at half its length, ten overhang by 0.2929 m",
    "[dem][finite]")
{
    const int n = GENERATE(1, 10);
    CHECK(largest_turn(n, 0.99) < 0.01);
    CHECK(largest_turn(n, 1.01) >= 0.3);
}

TEST_CASE(
    "finite wall: registers give the bits of walls alone, though some walls slide and others "
    "do not",
    "[dem][finite]")
{
    scenes::Scene scene = small_wall::scene();
    const dem::Model m = small_wall::model(scene);
    dem::PushPlan plan = small_wall::to(0.02);
    const auto material = [&](std::size_t i) -> dem::WallMaterials {
        dem::WallMaterials w = scenes::table5_sample(scene, m, i);
        for (auto& j : w.joints) j.tan_phi *= i % 2 == 0 ? 0.3 : 1.0;
        return w;
    };
    std::vector<dem::PushResult> together(5);
    dem::push_ensemble(
        m,
        {5, material, [&](std::size_t i, dem::PushResult&& r) { together[i] = std::move(r); }},
        plan, finite(), {.threads = 1});
    for (std::size_t i = 0; i < together.size(); ++i) {
        const dem::PushResult alone = dem::push(m, material(i), plan, finite());
        CHECK(small_wall::same(together[i], alone));
        CHECK(alone.residual < 0.01);
    }
}

TEST_CASE(
    "finite wall: as displacements vanish it is the wall with small displacements, and the "
    "difference grows with the displacement",
    "[dem][finite]")
{
    scenes::Scene s = scenes::monolith(1.0, 0.9, 0.5e6, 8e9);
    s.joint.tan_phi = 10.0;
    dem::Discretisation d;
    d.block_modes = d.beam_modes = 6;
    const dem::Model m = scenes::model_of(s, d);
    const auto force = [&](dem::Kinematics k, double u) {
        dem::SolverOptions o;
        o.kinematics = k;
        return dem::push(m, scenes::uniform(s, m), small_wall::to(u), o).curve.back().force;
    };
    const auto difference = [&](double u) {
        return 1.0 - force(dem::Kinematics::finite, u) / force(dem::Kinematics::small, u);
    };
    const double one = difference(2e-3), two = difference(4e-3);
    const double near_zero =
        5e-5; // the joint is still closed: P-delta takes a share of the stiffness
    CHECK(std::abs(difference(near_zero)) * force(dem::Kinematics::small, near_zero) <
          2e-4 * force(dem::Kinematics::small, 4e-3));
    CHECK(one == Approx(0.0065).epsilon(0.3));
    CHECK(two / one == Approx(2.0).epsilon(0.15));
}

TEST_CASE("finite wall: a wall that is turned rigidly by any angle feels nothing",
          "[dem][finite]")
{
    const double th = GENERATE(0.01, -0.7, 1.5, 3.0, -6.0);
    scenes::Scene scene = small_wall::scene();
    scene.wall.base = dem::Base::joint;
    scene.wall.toe = dem::Toe::free;
    const dem::Model m = small_wall::model(scene);
    const dem::FiniteTables t = dem::step_tables(m).finite;
    std::vector<dem::BlockFrame<double>> frames(t.blocks.size() + 1);
    for (std::size_t b = 0; b < frames.size(); ++b) {
        const bool ground = b == t.blocks.size();
        const double x = ground ? 0.0 : t.blocks[b].x, z = ground ? 0.0 : t.blocks[b].z;
        auto& f = frames[b];
        f.x = 0.3 + x * std::cos(th) + z * std::sin(th);
        f.z = -0.2 + z * std::cos(th) - x * std::sin(th);
        f.turn = th;
        f.half = dem::half_turn(th);
        f.spin = 0.01; // and goes on turning about the origin
        f.vx = f.spin * f.z;
        f.vz = -f.spin * f.x;
    }
    for (const dem::FacePair& p : t.pairs) {
        const auto o = dem::overlap_of(p, frames[p.a], frames[p.b], 0.5);
        CHECK(std::abs(o.gap) < 1e-10);
        CHECK(std::abs(o.widening) < 1e-10);
        CHECK(std::abs(dem::share_of(p, o, 1.0) - 1.0) < 1e-10);
        CHECK(std::abs(dem::slip_of(o, frames[p.a], frames[p.b])) < 1e-10);
    }
}

TEST_CASE(
    "finite wall: a beam that slides over a head joint takes tan(phi) N all the way, without "
    "a jump",
    "[dem][finite]")
{
    scenes::Scene s = small_wall::scene(0.50, 1);
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.wall.unit_length = 0.1;
    s.beam.interface = dem::BeamInterface::joint;
    s.joint.tan_phi = 0.3;
    const dem::Model m = small_wall::model(s);
    dem::PushPlan plan =
        small_wall::to(0.15); // over the head joint at 0.1 m; further out the beam would tilt
    plan.record_every = 2e-4;
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan, finite());
    const double force =
        0.3 * (0.50e6 * 0.6 * 0.2 + s.beam.material.density * 9.81 * 0.6 * 0.2 * s.beam.height);
    double farthest = 0.0, jump = 0.0;
    for (std::size_t i = 1; i < r.curve.size(); ++i) {
        if (r.curve[i].displacement < 2e-3) continue;
        farthest = std::max(farthest, std::abs(r.curve[i].force / force - 1.0));
        jump = std::max(jump, std::abs(r.curve[i].force - r.curve[i - 1].force) / force);
    }
    INFO("farthest " << farthest << ", jump " << jump);
    CHECK(r.residual < 0.01);
    CHECK(farthest < 0.005);
    CHECK(jump < 0.001);
}
