/// Strength of a unit with potential cracks, and what it takes to break it: a disc that splits,
/// a beam, a bar that is torn off; and the stiffness of a wall that does not crack.

#include "dem/block/model.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/paper_materials.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/state/elastic_operator.hpp"
#include "dem/solver/static_start.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/small_wall.hpp"

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

/// How fast parts fly off once a unit breaks under a dead load. A contact that passes all of
/// its softening in one step takes more than G: the energies are those of small steps.
enum class Steps { usual, small };

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

    /// Under its vertical load, which alone matters: the push is a micrometre at constant
    /// speed.
    [[nodiscard]] dem::PushResult stand(double steps_per_mm, Steps steps) const
    {
        dem::PushPlan plan;
        plan.targets = {1e-6};
        plan.record_every = 1e-6;
        dem::SolverOptions options;
        options.steps_per_mm = steps_per_mm;
        options.unbalance_limit = 0.0;
        options.accuracy = 0.5;
        if (steps == Steps::small) {
            options.step_fraction = 0.1;
            options.preload_steps = 10000;
        }
        return push(plan, options);
    }

    [[nodiscard]] dem::PushResult push(const dem::PushPlan& plan,
                                       const dem::SolverOptions& options) const
    {
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
dem::PushResult loaded(const CrackPattern& pattern, double ratio, Steps steps = Steps::usual)
{
    Unit u(disc(), pattern);
    u.zones.contact_points = 9;
    u.beam.height = 0.01;
    u.beam.material = {100e9, 0.2, 2300.0};
    u.loads.gravity = 0.0;
    u.loads.height = std::ranges::max(disc(), {}, &Point::z).z;
    u.loads.vertical_stress = ratio * 0.5 * std::numbers::pi * kDiameter * kStrength / kFlat;
    return u.stand(1000, steps);
}

constexpr double kDepth = 0.1, kSpan = 0.8,
                 kPlaten = 0.01; // of the beam and what it lies on [m]

std::vector<Point> box(double x, double z, double width, double height)
{
    return {{x, z}, {x + width, z}, {x + width, z + height}, {x, z + height}};
}

/// Elastic peak over 2 f_T t d^2 / (3 s): the force flattens the stress below it (Timoshenko
/// and Goodier, Theory of elasticity, section 40).
const double kFlattened = 1.0 / (1.0 - 4.0 / (3.0 * std::numbers::pi) * kDepth / kSpan);

/// A beam on two blocks under a force on a third one, P = ratio times its elastic peak.
/// @param points of half a unit
dem::PushResult bent(const CrackPattern& pattern, double ratio, int points = 33,
                     Steps steps = Steps::usual)
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
    u.zones.contact_points = points;
    u.beam.height = 0.01;
    u.beam.material = {100e9, 0.2, 2300.0};
    u.loads.gravity = 0.0;
    u.loads.height = kTop + 0.02;
    u.loads.vertical_stress =
        ratio * kFlattened * 2.0 * kStrength * kDepth * kDepth / (3.0 * kSpan) / kPlaten;
    return u.stand(1e6, steps);
}

/// Areas of cracks [m2].
struct Broken {
    double all = 0.0, through = 0.0; ///< of those with D = 1
    double damage = 0.0;             ///< integral of D over the area
};

Broken broken(const dem::Snapshot& s)
{
    Broken b;
    for (const dem::FaceState& f : s.faces)
        for (const dem::ContactState& c : f.contacts) {
            if (f.kind != dem::FaceKind::unit_crack) continue;
            b.all += c.area;
            b.through += c.damage >= 1.0 ? c.area : 0.0;
            b.damage += c.damage * c.area;
        }
    return b;
}

/// In tension a contact with linear softening and secant unloading has lost D G per area: f_T
/// u_max / 2 under the curve less sigma u_el / 2 that comes back, with u_max = u_el + D (u_ul -
/// u_el).
void check_energy(const dem::PushResult& r)
{
    CHECK(r.energy.fracture == Approx(kEnergy * broken(r.at_end).damage).epsilon(0.01));
    CHECK(r.residual < 0.01);
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

TEST_CASE("crack strength: a beam breaks at three points at its elastic peak", "[dem][cracks]")
{
    const CrackPattern pattern =
        GENERATE(CrackPattern{Kind::grid, 8, 2}, CrackPattern{Kind::grid, 16, 4});
    CHECK(broken(bent(pattern, 0.97).at_end).through == 0.0);
    CHECK(broken(bent(pattern, 1.03).at_end).through > 0.95 * kDepth * kThickness);
}

TEST_CASE("crack strength: what breaks takes G times the damage of its area, in any grid",
          "[dem][cracks][slow]")
{
    for (const CrackPattern& pattern :
         {CrackPattern{Kind::grid, 2, 2}, CrackPattern{Kind::grid, 4, 4}}) {
        const dem::PushResult r = loaded(pattern, 1.03, Steps::small);
        CHECK(broken(r.at_end).through > kDiameter * kThickness); // along the sides too
        check_energy(r);
    }
    for (const CrackPattern& pattern :
         {CrackPattern{Kind::grid, 8, 2}, CrackPattern{Kind::grid, 16, 4}}) {
        const dem::PushResult r = bent(pattern, 1.03, 33, Steps::small);
        CHECK(broken(r.at_end).through > 0.95 * kDepth * kThickness);
        check_energy(r);
    }
}

TEST_CASE("crack strength: a disc and a beam with one crack take G times its area",
          "[dem][cracks]")
{
    const dem::PushResult disc = loaded({Kind::mid}, 1.03, Steps::small);
    CHECK(disc.energy.fracture == Approx(kEnergy * broken(disc.at_end).all).epsilon(0.01));
    check_energy(disc);
    for (const int points : {65, 97}) {
        const dem::PushResult beam = bent({Kind::mid}, 1.03, points, Steps::small);
        CHECK(broken(beam.at_end).through == Approx(kDepth * kThickness));
        CHECK(beam.energy.fracture == Approx(kEnergy * kDepth * kThickness).epsilon(0.01));
    }
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
    const dem::PushResult r = u.push(plan, {.accuracy = 0.001});
    double factor = 0.0;
    for (const dem::CurvePoint& p : r.curve) factor = std::max(factor, p.force / r.weight);
    const double area = 0.4 * kThickness, bar = 2300.0 * 9.81 * 0.4 * area; // [m2], [N]
    CHECK(factor * bar == Approx(kStrength * area).epsilon(0.01));
    CHECK(r.energy.fracture == Approx(400.0 * area).epsilon(1e-6));
    CHECK(r.residual < 0.01);
}

namespace {

/// Force on the beam over its displacement, of the wall at rest in which nothing opens, slips
/// or cracks [N/m].
/// @param joints stiffness over that of the paper's
double elastic_stiffness(const CrackPattern& pattern, double joints)
{
    scenes::Scene scene = scenes::paper_wall(0.75);
    scene.joint.kn *= joints;
    scene.joint.ks *= joints;
    scene.wall.cracks.pattern = pattern;
    const dem::Model m = scenes::model_of(scene);
    dem::WallMaterials w = scenes::uniform(scene, m);
    for (std::size_t k = 0; k < w.cracks.size(); ++k)
        if (const double own = dem::own_stiffness(m.layout, k); own > 0.0)
            w.cracks[k].kn = w.cracks[k].ks = own * scene.stone.young_modulus;
    const dem::StepTables t = dem::step_tables(m);
    dem::WallState<double> s = dem::unloaded<double>(m, t, {&w, 1}, {});
    std::vector<double> driven(s.du.size(), 0.0), du = driven; // by 1 m, with all else held
    for (const dem::HorizontalShare& h : t.beam) driven[h.row] += h.factor;
    dem::elastic_stress(t, s, driven, s.stress);
    for (const auto& b : t.blocks)
        dem::gather(t.matrices[b.element], t.port_contact.data() + b.first_port, t.area.data(),
                    s.stress.data(), s.laws.load.data() + b.first_mode);
    REQUIRE(dem::solve_preload(t, s));
    dem::stretch(t, s.q, du);
    for (std::size_t i = 0; i < du.size(); ++i) du[i] += driven[i];
    dem::elastic_stress(t, s, du, s.stress);
    double force = 0.0;
    for (const dem::HorizontalShare& h : t.beam) force += h.area * h.factor * s.stress[h.row];
    return force;
}

} // namespace

TEST_CASE("crack strength: cracks that share the stiffness of a unit leave that of the wall",
          "[dem][cracks][slow]")
{
    // With joints a hundred times as stiff it is the stone that gives way, not the joints.
    const double whole = elastic_stiffness({Kind::none}, 1.0),
                 stone = elastic_stiffness({Kind::none}, 100.0);
    for (const CrackPattern& pattern :
         {CrackPattern{Kind::grid, 2, 2}, CrackPattern{Kind::grid, 4, 4},
          CrackPattern{Kind::diagonals}, CrackPattern{Kind::voronoi, 1, 1, 0.05}}) {
        CHECK(elastic_stiffness(pattern, 1.0) == Approx(whole).epsilon(0.015));
        CHECK(elastic_stiffness(pattern, 100.0) == Approx(stone).epsilon(0.03));
    }
    // The paper's cracks add to the unit.
    CHECK(elastic_stiffness({Kind::mid}, 1.0) / whole - 1.0 == Approx(-0.0297).margin(5e-4));
    CHECK(elastic_stiffness({Kind::grid, 3, 1}, 1.0) / whole - 1.0 ==
          Approx(-0.0378).margin(5e-4));
}
