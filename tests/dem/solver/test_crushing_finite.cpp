/// Joints that crush, with finite displacements: what the load crushes before the push, joints
/// that are crushed deeper than blocks may pass into each other, and blocks that slide on with
/// a crushed face.

#include "dem/block/model.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/finite_step.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using dem::Kinematics;

dem::Model crushing_model(const scenes::Scene& s)
{
    dem::Layout layout = dem::lay_out(s.wall, s.beam.height);
    layout.crushing = true;
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = d.beam_modes = 6;
    return dem::discretise(layout, s.stone, s.beam, s.loads, {s.joint, s.crack}, d);
}

/// @param stiffer every second joint is so much stiffer and gathers the load [-]
dem::WallMaterials crushing_wall(const scenes::Scene& s, const dem::Model& m, double strength,
                                 double stiffer = 1.0)
{
    dem::WallMaterials w = scenes::uniform(s, m);
    for (std::size_t i = 0; i < w.joints.size(); ++i) {
        w.joints[i].crushing.strength = strength;
        if (i % 2 == 0) continue;
        w.joints[i].kn *= stiffer;
        w.joints[i].ks *= stiffer;
    }
    return w;
}

dem::PushResult pushed(double strength, double stiffer, Kinematics kinematics)
{
    const scenes::Scene s = small_wall::scene();
    const dem::Model m = crushing_model(s);
    dem::SolverOptions o = small_wall::quick();
    o.kinematics = kinematics;
    return dem::push(m, crushing_wall(s, m, strength, stiffer), small_wall::to(1e-4), o);
}

} // namespace

TEST_CASE("crushing: what the vertical load crushes is not forgotten when the push begins",
          "[dem][crushing]")
{
    for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
        const dem::PushResult r = pushed(0.9e6, 4.0, kinematics);
        CHECK(r.outcome == dem::Outcome::reached_target);
        CHECK(r.step_reductions == 0);
        CHECK(r.residual < 1e-3);
        CHECK(r.curve.front().energy.crushing > 0.5);
    }
}

TEST_CASE("crushing: a lane gets all that was lost as the frames were taken up",
          "[dem][crushing][pack]")
{
    const scenes::Scene s = small_wall::scene();
    const dem::Model m = crushing_model(s);
    const dem::StepTables t = dem::step_tables(m);
    dem::WallMaterials w = crushing_wall(s, m, 0.9e6, 4.0);
    for (dem::CrackMaterial& c : w.cracks) c.ft = 1e3;
    w.cracks.front().crushing.strength = 1e3; // it loses its bond
    dem::SolverOptions o;
    o.kinematics = Kinematics::finite;
    dem::WallState<double> one = dem::unloaded<double>(m, t, {&w, 1}, o);
    REQUIRE(dem::solve_preload(t, one));
    dem::take_up_frames(t, o, one);
    REQUIRE(one.crushing > 0.0);
    REQUIRE(one.fracture > 0.0);
    REQUIRE(std::ranges::count(one.cracks, 0.0, &dem::WallState<double>::Memory::bond) > 0);
    const int lane = dem::lanes<dem::Pack> - 1;
    auto pack = dem::unloaded<dem::Pack>(m, t, {&w, 1}, o);
    dem::copy_to_lane(one, lane, pack);
    const dem::Energy alone = dem::energy_of(t, one, 0), there = dem::energy_of(t, pack, lane);
    CHECK(small_wall::same(alone, there));
    for (std::size_t k = 0; k < one.crushed.size(); ++k)
        REQUIRE(bits::same(pack.crushed[k][lane], one.crushed[k]));
    for (std::size_t k = 0; k < one.cracks.size(); ++k) {
        const auto& a = one.cracks[k];
        const auto& b = pack.cracks[k];
        REQUIRE(bits::same(b.u_max[lane], a.u_max));
        REQUIRE(bits::same(b.bond[lane], a.bond));
        REQUIRE(bits::same(b.unloading[lane], a.unloading));
        REQUIRE(bits::same(b.integrity[lane], a.integrity));
    }
}

TEST_CASE("crushing: a joint is crushed as deep with finite displacements as with small ones",
          "[dem][crushing]")
{
    // 4.9 kJ are 54 mm of all bed joints together, on 0.6 m x 0.2 m under 0.76 MPa; blocks have
    // passed each other at 5 mm.
    const dem::PushResult small = pushed(0.76e6, 1.0, Kinematics::small),
                          finite = pushed(0.76e6, 1.0, Kinematics::finite);
    CHECK(small.energy.crushing > 4e3);
    CHECK(finite.energy.crushing == Approx(small.energy.crushing).epsilon(0.01));
    CHECK(finite.residual < 1e-4);
}

TEST_CASE("crushing: a wall that sinks through its joints has come down", "[dem][crushing]")
{
    for (const Kinematics kinematics : {Kinematics::small, Kinematics::finite}) {
        const dem::PushResult r = pushed(0.7e6, 1.0, kinematics); // under 0.75 MPa
        CHECK(r.outcome == dem::Outcome::lost_equilibrium);
        CHECK(r.residual < 0.01);
    }
}

TEST_CASE("crushing: the ledger holds where area is lost while it crushes", "[dem][crushing]")
{
    // The static solution has these joints pressed together by more than blocks may be, with
    // more than they carry.
    scenes::Scene s = small_wall::scene();
    s.joint.kn = s.joint.ks = 5e6;
    const dem::Model m = crushing_model(s);
    const dem::StepTables t = dem::step_tables(m);
    const dem::WallMaterials w = crushing_wall(s, m, 0.5e6);
    dem::SolverOptions o;
    o.kinematics = Kinematics::finite;
    dem::WallState<double> wall = dem::unloaded<double>(m, t, {&w, 1}, o);
    REQUIRE(dem::solve_preload(t, wall));
    const double stored = dem::energy_of(t, wall, 0).elastic;
    dem::take_up_frames(t, o, wall);
    const dem::Energy e = dem::energy_of(t, wall, 0);
    CHECK(std::ranges::count(wall.finite.pairs, 0.0, [](const auto& p) { return p.share; }) >
          0);
    CHECK(e.elastic < 0.5 * stored);
    CHECK(e.crushing > 0.1 * stored);
    CHECK(std::abs(e.residual()) < 1e-9);
}

namespace {

constexpr double kWidth = 0.2, kHigh = 0.1, kDeep = 0.1; // of the three blocks [m]
constexpr double kLoad = 0.5e6, kFriction = 0.5;         // [Pa], [-]

/// Two blocks side by side and one on the first, which slides half onto the second. What is
/// between it and the first has been crushed before.
struct Slide {
    double force = 0.0;
    dem::Energy energy;
};

Slide slide(double crushed)
{
    dem::DrawnWall wall;
    wall.thickness = kDeep;
    const auto box = [](double x, double z) -> dem::DrawnUnit {
        return {{{x, z}, {x + kWidth, z}, {x + kWidth, z + kHigh}, {x, z + kHigh}}, 0};
    };
    wall.units = {box(0.0, 0.0), box(kWidth, 0.0), box(0.0, kHigh)};
    dem::Beam beam;
    beam.height = 0.05;
    beam.material = {30e9, 0.2, 2300.0};
    beam.rotation = dem::BeamRotation::fixed;
    dem::Layout layout = dem::drawn_layout(wall, beam.height);
    layout.crushing = true;
    dem::Loads loads;
    loads.vertical_stress = kLoad;
    loads.height = 2.0 * kHigh;
    const dem::JointMaterial joint{.kn = 10e9, .ks = 4e9, .tan_phi = kFriction};
    dem::Discretisation d;
    d.block_modes = d.beam_modes = 6;
    const dem::Elastic stone{15.5e9, 0.2, 2300.0};
    const dem::Model m =
        dem::discretise(layout, stone, beam, loads, {joint, {.kn = 1e11, .ks = 1e11}}, d);
    dem::WallMaterials w;
    w.stone = stone;
    w.joints.assign(static_cast<std::size_t>(layout.n_joints), joint);
    for (dem::JointMaterial& j : w.joints) j.crushing.strength = 20e6;
    w.base_joint = w.beam_joint = joint;

    dem::SolverOptions o;
    o.kinematics = Kinematics::finite;
    const dem::StepTables t = dem::step_tables(m);
    dem::WallState<double> s = dem::unloaded<double>(m, t, {&w, 1}, o);
    REQUIRE(dem::solve_preload(t, s));
    dem::take_up_frames(t, o, s);
    for (std::size_t p = 0; p < t.dry.size(); ++p) {
        const dem::FacePair& pair = t.finite.pairs[p];
        if (pair.a != 0 || pair.b != 2) continue;
        for (int k = 0; k < t.dry[p].count; ++k) s.crushed[t.dry[p].first + k] = crushed;
        s.finite.pairs[p].gap -= crushed;
    }
    for (const int sunk : {2, t.finite.beam}) s.finite.frames[sunk].z -= crushed;
    const int steps = 40000;
    for (int i = 0; i < steps; ++i)
        dem::step<double>(t, o, {1.0, 0.5 * kWidth / steps, 1.0}, s);
    return {s.top_force, dem::energy_of(t, s, 0)};
}

} // namespace

TEST_CASE("crushing: a block brings its crushed face along onto the next block",
          "[dem][crushing][finite]")
{
    const double friction = kFriction * kLoad * kWidth * kDeep;
    const Slide plain = slide(0.0), crushed = slide(1e-3); // k_n times 1 mm is 10 MPa
    CHECK(plain.force == Approx(friction).epsilon(0.02));
    CHECK(crushed.force == Approx(plain.force).epsilon(1e-3));
    CHECK(crushed.energy.friction == Approx(plain.energy.friction).epsilon(1e-3));
    CHECK(crushed.energy.crushing == 0.0);
}
