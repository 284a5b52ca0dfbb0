/// What a unit with potential cracks carries: a disc that splits, an arm that is torn off, and the stiffness of a wall
/// that does not crack.

#include "dem/block/model.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/paper_materials.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"
#include "small_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using dem::CrackPattern;
using dem::Point;
using Kind = CrackPattern::Kind;

constexpr double kThickness = 0.1; // [m]
constexpr double kStrength = 1e6;  // f_T [Pa]
constexpr double kEnergy = 1.0;    // G [J/m2]

/// One drawn unit, its materials and what is on it.
struct Unit {
    dem::DrawnWall wall;
    dem::Beam beam;
    dem::Loads loads;
    dem::PaperMaterials stone;
    dem::Discretisation zones;

    Unit(std::vector<Point> outline, const CrackPattern& pattern)
    {
        wall.units = {{std::move(outline), 0}};
        wall.thickness = kThickness;
        wall.unit_length = 0.2;
        wall.cracks.pattern = pattern;
        stone.stone = {15.5e9, 0.2, 2300.0};
        stone.joint.kn = 100e9;
        stone.joint.ks = 40e9;
        stone.crack.tensile_strength = kStrength;
        stone.crack.cohesion = 100.0 * kStrength;
        stone.crack.fracture_energy = kEnergy;
        zones = dem::discretisation_of(dem::Fidelity::zones);
    }

    [[nodiscard]] dem::PushResult push(const dem::PushPlan& plan,
                                       double steps_per_mm = 1000) const
    {
        dem::SolverOptions options;
        options.steps_per_mm = steps_per_mm;
        const dem::ReferenceStiffness reference = {
            dem::joint_material(stone.joint),
            dem::crack_material(stone.crack, stone.joint.kn, stone.stone.poisson_ratio)};
        const dem::Model model =
            dem::discretise(dem::drawn_layout(wall, beam.present ? beam.height : 0.0),
                            stone.stone, beam, loads, reference, zones);
        return dem::push(model, dem::wall_materials(stone, model.layout), plan, options);
    }
};

constexpr double kDiameter = 0.2, kFlat = 0.012; // of the disc and its two platens [m]

std::vector<Point> disc()
{
    constexpr int kSides = 32; // of either half
    const double r = 0.5 * kDiameter, flat = std::asin(0.5 * kFlat / r);
    std::vector<Point> outline;
    for (const double half : {-0.5, 0.5})
        for (int i = 0; i <= kSides; ++i) {
            const double a =
                half * std::numbers::pi + flat + (std::numbers::pi - 2.0 * flat) * i / kSides;
            outline.push_back({r + r * std::cos(a), r * std::cos(flat) + r * std::sin(a)});
        }
    return outline;
}

/// A disc under a vertical force P = ratio pi D t f_T / 2.
dem::PushResult loaded(const CrackPattern& pattern, double ratio)
{
    Unit u(disc(), pattern);
    u.zones.contact_points = 9;
    u.beam.height = 0.01;
    u.beam.material = {100e9, 0.2, 2300.0};
    u.loads.gravity = 0.0;
    u.loads.height = std::ranges::max(disc(), {}, &Point::z).z;
    u.loads.vertical_stress = ratio * 0.5 * std::numbers::pi * kDiameter * kStrength / kFlat;
    dem::PushPlan plan;
    plan.targets = {1e-6};
    plan.record_every = 1e-6;
    return u.push(plan);
}

constexpr double kDepth = 0.1, kSpan = 0.8,
                 kPlaten = 0.01; // of the beam and what it lies on [m]

std::vector<Point> box(double x, double z, double width, double height)
{
    return {{x, z}, {x + width, z}, {x + width, z + height}, {x, z + height}};
}

/// A beam on two blocks under a force on a third one, P = ratio 2 f_T t d^2 / (3 s).
dem::PushResult bent(const CrackPattern& pattern, double ratio)
{
    constexpr double kLength = kSpan + 5.0 * kPlaten, kLow = 0.05, kTop = kLow + kDepth;
    Unit u(box(0.0, kLow, kLength, kDepth), pattern);
    for (const double middle : {-0.5, 0.5})
        u.wall.units.push_back(
            {box(0.5 * (kLength - kPlaten) + middle * kSpan, 0.0, kPlaten, kLow), 0});
    u.wall.units.push_back({box(0.5 * (kLength - kPlaten), kTop, kPlaten, 0.02), 0});
    u.wall.unit_length = kLength;
    u.wall.cracks.where = {dem::Region{0.0, kLow, kLength, kTop}};
    u.wall.cracks.elsewhere = {Kind::none};
    u.zones.contact_points = 33; // of half a unit
    u.beam.height = 0.01;
    u.beam.material = {100e9, 0.2, 2300.0};
    u.loads.gravity = 0.0;
    u.loads.height = kTop + 0.02;
    u.loads.vertical_stress =
        ratio * 2.0 * kStrength * kDepth * kDepth / (3.0 * kSpan) / kPlaten;
    dem::PushPlan plan;
    plan.targets = {1e-6};
    plan.record_every = 1e-6;
    return u.push(plan, 1e6);
}

/// Of cracks [m2]: with D = 1, and with D between 0 and 1.
struct Broken {
    double through = 0.0, partly = 0.0;
};

Broken broken(const dem::Snapshot& s)
{
    Broken b;
    for (const dem::FaceState& f : s.faces)
        for (const dem::ContactState& c : f.contacts)
            if (f.kind == dem::FaceKind::unit_crack && c.damage > 0.0)
                (c.damage >= 1.0 ? b.through : b.partly) += c.area;
    return b;
}

} // namespace

TEST_CASE("crack strength: a disc splits at 2 P / (pi D t) = f_T", "[dem][cracks]")
{
    const CrackPattern pattern =
        GENERATE(CrackPattern{Kind::mid}, CrackPattern{Kind::grid, 2, 2},
                 CrackPattern{Kind::grid, 4, 4});
    CHECK(broken(loaded(pattern, 0.97).at_end).through == 0.0);
    CHECK(broken(loaded(pattern, 1.03).at_end).through > 0.5 * kDiameter * kThickness);
}

TEST_CASE("crack strength: a beam breaks at three points at its elastic peak, and takes G d t",
          "[dem][cracks]")
{
    const CrackPattern pattern =
        GENERATE(CrackPattern{Kind::grid, 8, 2}, CrackPattern{Kind::grid, 16, 4});
    // The force flattens the stress below it: Timoshenko and Goodier, Theory of elasticity, section 40.
    const double elastic = 1.0 / (1.0 - 4.0 / (3.0 * std::numbers::pi) * kDepth / kSpan);
    CHECK(broken(bent(pattern, 0.97 * elastic).at_end).through == 0.0);
    const dem::PushResult r = bent(pattern, 1.03 * elastic);
    const Broken b = broken(r.at_end);
    CHECK(b.through > 0.95 * kDepth * kThickness);
    CHECK(r.energy.fracture >= 0.9999 * kEnergy * b.through);
    CHECK(r.energy.fracture <= kEnergy * (b.through + b.partly));
}

TEST_CASE("crack strength: a bar is torn off at f_T A, and takes G A", "[dem][cracks]")
{
    // A post with a bar of 0.4 m x 0.4 m on its right, which lies on a smooth slab.
    Unit u({{0, 0}, {0.4, 0}, {0.4, 0.1}, {0.8, 0.1}, {0.8, 0.5}, {0, 0.5}},
           {Kind::grid, 2, 1});
    u.wall.units.push_back({{{0.4, 0}, {1.2, 0}, {1.2, 0.1}, {0.4, 0.1}}, 0});
    u.wall.unit_length = 0.8;
    u.zones.contact_points = GENERATE(3, 9);
    u.beam.present = false;
    u.loads.pattern = dem::LoadPattern::body;
    u.stone.stone.young_modulus = 1e12;
    u.stone.crack.stiffness_ratio = 1.0;
    u.stone.crack.fracture_energy = 400.0; // more brittle, it tears from one edge
    dem::PushPlan plan;
    plan.targets = {5e-4}; // of the mean of all blocks; the bar goes 1.4 mm
    plan.record_every = 1e-6;
    const dem::PushResult r = u.push(plan, 20000);
    double factor = 0.0;
    for (const dem::CurvePoint& p : r.curve) factor = std::max(factor, p.force / r.weight);
    const double area = 0.4 * kThickness, bar = 2300.0 * 9.81 * 0.4 * area; // [m2], [N]
    CHECK(factor * bar == Approx(kStrength * area).epsilon(0.01));
    CHECK(r.energy.fracture == Approx(400.0 * area).epsilon(1e-6));
    CHECK(r.residual < 0.01);
}

TEST_CASE("crack strength: cracks leave the elastic stiffness of a wall as it was",
          "[dem][cracks]")
{
    const auto pushed = [](const CrackPattern& pattern) {
        scenes::Scene s = small_wall::scene();
        s.wall.cracks.pattern = pattern;
        s.crack.ft = s.crack.cohesion = 1e12;
        const dem::Model m = scenes::model_of(s);
        dem::WallMaterials w = scenes::uniform(s, m);
        for (std::size_t k = 0; k < w.cracks.size(); ++k)
            w.cracks[k].kn = w.cracks[k].ks =
                dem::own_stiffness(m.layout, k) * s.stone.young_modulus;
        dem::SolverOptions slow;
        slow.steps_per_mm = 100000;
        return dem::push(m, w, small_wall::to(1e-4), slow);
    };
    const dem::PushResult whole = pushed({Kind::none});
    for (const CrackPattern& pattern :
         {CrackPattern{Kind::grid, 4, 2}, CrackPattern{Kind::voronoi, 1, 1, 0.06}}) {
        const dem::PushResult r = pushed(pattern);
        CHECK(r.settlement == Approx(whole.settlement).epsilon(0.01));
        CHECK(r.curve.back().force == Approx(whole.curve.back().force).epsilon(0.02));
    }
}
