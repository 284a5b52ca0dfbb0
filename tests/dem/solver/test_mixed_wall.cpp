/// Walls whose cracks, and whose mortar, follow the law of mixed modes.

#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/brittle_contacts.hpp"
#include "dem/solver/step/crack_kernels.hpp"
#include "dem/solver/step/step.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace {

using dem::Envelope;
using dem::PushResult;
using dem::WallMaterials;

/// Two courses of one unit each on mortar, the lower one held.
scenes::Scene two_courses(double length, double height, double stress)
{
    scenes::Scene s = scenes::monolith(length, height, stress, 1e10);
    s.wall.courses = 2;
    s.wall.bond_offset = 0.0;
    s.wall.base = dem::Base::fixed;
    s.loads.height = 2.0 * height + 0.1;
    s.beam.height = 0.1;
    s.joint.envelope = Envelope::hyperbolic;
    return s;
}

dem::Model mortar_model(const scenes::Scene& s, int points, bool mixed = true)
{
    dem::Layout layout = dem::lay_out(s.wall, s.beam.height);
    layout.mortar = true;
    layout.mixed_mode = mixed;
    dem::Discretisation d;
    d.contact_points = points;
    return dem::discretise(layout, s.stone, s.beam, s.loads, {s.joint, s.crack}, d);
}

std::vector<PushResult> pushed(const dem::Model& m, const std::vector<WallMaterials>& walls,
                               const dem::PushPlan& plan, const dem::SolverOptions& o)
{
    std::vector<PushResult> results(walls.size());
    dem::Ensemble ensemble;
    ensemble.size = walls.size();
    ensemble.wall = [&](std::size_t i) { return std::optional(walls[i]); };
    ensemble.done = [&](std::size_t i, PushResult&& r) { results[i] = std::move(r); };
    dem::push_ensemble(m, ensemble, plan, o, {});
    return results;
}

double drop(const PushResult& r)
{
    double peak = 0.0, at = 0.0;
    for (const dem::CurvePoint& p : r.curve) {
        if (p.force > peak) peak = p.force, at = 0.0;
        if (at == 0.0 && p.force < 0.8 * peak) at = p.displacement;
    }
    return at;
}

/// Walls of all kinds for the lanes of a register: weak, strong, brittle and tough units, both
/// envelopes.
std::vector<WallMaterials> some_walls(const scenes::Scene& s, const dem::Model& m)
{
    std::vector<WallMaterials> walls;
    for (int i = 0; i < 9; ++i) {
        walls.push_back(scenes::uniform(s, m));
        for (dem::CrackMaterial& c : walls.back().cracks) {
            c.ft = c.cohesion = (1.0 + 0.25 * i) * 1e6;
            c.envelope = i % 2 ? Envelope::coulomb : Envelope::hyperbolic;
            c.shear_fracture_energy = i % 3 * 200.0;
        }
    }
    return walls;
}

} // namespace

TEST_CASE("mixed wall: a bed joint in shear costs G_II by its area, whatever its stiffness and "
          "the number of its contact points",
          "[dem][mixed_wall]")
{
    scenes::Scene s = two_courses(1.0, 0.1, 1.0e6); // closed all the time
    s.joint.cohesion = 0.2e6;
    s.joint.tan_phi = 0.2;
    s.joint.shear_fracture_energy = 50.0;
    s.joint.ks *= GENERATE(0.5, 1.0);
    const int points = GENERATE(3, 5);
    const dem::Model m = mortar_model(s, points);
    dem::SolverOptions o;
    o.accuracy = 0.002;
    const PushResult r = dem::push(m, scenes::uniform(s, m), small_wall::to(1.5e-3), o);
    CHECK(r.residual < 0.01);
    CHECK(r.energy.fracture == Approx(50.0 * s.wall.length * s.wall.thickness).epsilon(1e-3));
    CHECK(r.crack_contacts == 2 * points - 1); // of two half units
    CHECK(r.softened_in_shear == r.crack_contacts);
    CHECK(r.softened_in_tension == 0);
}

TEST_CASE("mixed wall: with the hyperbolic envelope a bonded joint loses nothing to friction",
          "[dem][mixed_wall]")
{
    scenes::Scene s = two_courses(0.8, 0.5, 0.05e6);
    s.joint.ft = s.joint.cohesion = 0.2e6;
    s.joint.fracture_energy = 50.0;
    const bool mixed = GENERATE(true, false);
    const double in_shear = mixed ? GENERATE(0.0, 50.0) : 0.0; // [J/m2]
    s.joint.envelope = mixed ? Envelope::hyperbolic : Envelope::coulomb;
    s.joint.shear_fracture_energy = in_shear;
    const dem::Model m = mortar_model(s, 9, mixed);
    std::vector<WallMaterials> walls;
    for (const double angle : {20.0, 31.8, 40.0, 50.0, 60.0}) {
        s.joint.tan_phi = scenes::tan_deg(angle);
        walls.push_back(scenes::uniform(s, m));
    }
    dem::PushPlan plan = small_wall::to(6e-4);
    plan.record_every = 1e-5;
    std::vector<double> peaks;
    for (const PushResult& r : pushed(m, walls, plan, {})) {
        CHECK(r.residual < 0.01);
        peaks.push_back(scenes::peak_force(r));
    }
    const auto [least, most] = std::minmax_element(peaks.begin(), peaks.end());
    if (!mixed)
        CHECK(*least < 0.5 * *most); // the paper's law
    else
        CHECK(*least > (in_shear > 0.0 ? 0.99 : 0.96) * *most);
}

TEST_CASE("mixed wall: twice the fracture energy in shear moves the drop of a wall",
          "[dem][mixed_wall]")
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.crack.ft = s.crack.cohesion = 2e6;
    s.crack.envelope = Envelope::hyperbolic;
    dem::Model m = small_wall::model(s);
    m.layout.mixed_mode = true;
    std::vector<WallMaterials> walls;
    for (const double energy : {500.0, 1000.0}) {
        s.crack.shear_fracture_energy = energy;
        walls.push_back(scenes::uniform(s, m));
    }
    dem::PushPlan plan = small_wall::to(0.021);
    const std::vector<PushResult> r = pushed(m, walls, plan, small_wall::quick());
    REQUIRE(drop(r[0]) > 0.0);
    CHECK(drop(r[1]) > 1.15 * drop(r[0]));
    for (const PushResult& one : r) {
        CHECK(one.residual < 0.01);
        CHECK(one.softened_in_tension > 0);
        CHECK(one.softened_in_shear > 0);
        CHECK(one.crack_contacts == 135);
    }
}

TEST_CASE("mixed wall: a wall has the same bits alone, in any lane, and without shortcuts",
          "[dem][mixed_wall][pack]")
{
    scenes::Scene s = small_wall::scene(1.25, 4);
    const bool crushes = GENERATE(false, true);
    if (crushes) s.crack.crushing = {10e6, 3e3};
    dem::Model m = small_wall::model(s);
    m.layout.mixed_mode = true;
    dem::SolverOptions o = small_wall::quick();
    o.kinematics = GENERATE(dem::Kinematics::small, dem::Kinematics::finite);
    const std::vector<WallMaterials> walls = some_walls(s, m);
    const dem::PushPlan plan = small_wall::to(6e-3);
    const std::vector<PushResult> together = pushed(m, walls, plan, o);
    int softened = 0;
    for (std::size_t i = 0; i < walls.size(); i += 4) {
        const PushResult alone = dem::push(m, walls[i], plan, o);
        CHECK(small_wall::same(alone, together[i]));
        CHECK(alone.residual < 0.01);
        softened += alone.softened_in_shear + alone.softened_in_tension;
    }
    CHECK(softened > 0);
    o.shortcuts = false;
    CHECK(small_wall::same(dem::push(m, walls[4], plan, o), together[4]));
}

TEST_CASE("mixed wall: contacts that ever lost a part of their strength are counted",
          "[dem][mixed_wall]")
{
    const scenes::Scene s = small_wall::scene(0.75, 4);
    dem::Model m = small_wall::model(s);
    dem::SolverOptions o = small_wall::quick();
    SECTION("law of mixed modes") { m.layout.mixed_mode = true; }
    SECTION("law of the paper") {}
    SECTION("uncoupled") { o.law = dem::ContactLaw::uncoupled; }
    const dem::StepTables t = dem::step_tables(m);
    WallMaterials w = scenes::uniform(s, m);
    for (std::size_t i = 0; i < w.cracks.size(); ++i) {
        dem::CrackMaterial& c = w.cracks[i];
        c.ft = 0.5e6;
        c.cohesion = i % 2 ? 0.5e6 : 3e6;
        if (m.layout.mixed_mode) c.shear_fracture_energy = i % 3 * 100.0;
    }
    dem::WallState<double> state = dem::unloaded<double>(m, t, {&w, 1}, o);
    REQUIRE(dem::solve_preload(t, state));
    std::vector<int> in_tension(state.cracks.size()), in_shear = in_tension;
    for (int i = 0; i < 6000; ++i) {
        dem::step(t, o, {1.0, 1e-6}, state);
        for (std::size_t k = 0; k < state.cracks.size(); ++k) {
            const auto& c = state.cracks[k];
            const double left =
                dem::tension_left(state.laws.cracks[m.cracks[k].material], c.u_max);
            const bool alive = c.bond > 0.0 || o.law == dem::ContactLaw::uncoupled;
            in_tension[k] |= left > 0.0 && left < 1.0 && alive;
            in_shear[k] |= c.bond > 0.0 && c.bond < 1.0;
        }
    }
    const auto sum = [](const std::vector<int>& v) {
        return static_cast<double>(std::count(v.begin(), v.end(), 1));
    };
    CHECK(state.softened_in_tension == sum(in_tension));
    CHECK(state.softened_in_shear == sum(in_shear));
    CHECK(sum(in_tension) > 0);
    CHECK((sum(in_shear) > 0) == m.layout.mixed_mode);
    dem::load_lane(m, t, w, o, 0, state);
    CHECK(state.softened_in_tension + state.softened_in_shear == 0.0);
}

TEST_CASE("mixed wall: contacts that snap back in shear are counted", "[dem][mixed_wall]")
{
    scenes::Scene s = scenes::paper_wall(0.50); // k_s 33.7 GPa/m: c^2 / (2 k_s) = 203.3 J/m2
    dem::Model m = scenes::model_of(s);
    m.layout.mixed_mode = true;
    const auto count = [&](double energy) {
        s.crack.shear_fracture_energy = energy;
        return dem::shear_snap_back_contacts(m, scenes::uniform(s, m));
    };
    CHECK(count(203.0) == 45 * 5);
    CHECK(count(204.0) == 0);
    CHECK(count(0.0) == 0); // brittle, as asked
    s.crack.cohesion_res = 1e6;
    CHECK(count(150.0) == 0);
    s.crack.cohesion_res = 0.0;
    s.crack.shear_fracture_energy = 203.0;
    CHECK(dem::push(m, scenes::uniform(s, m), small_wall::to(1e-5), small_wall::quick())
              .shear_snap_back_contacts == 45 * 5);
}

TEST_CASE("mixed wall: a crack that crushes has no bond left", "[dem][mixed_wall]")
{
    dem::CrackMaterial c = scenes::paper_wall(0.50).crack;
    c.shear_fracture_energy = 300.0;
    dem::CrackState<double> s = dem::intact(dem::crack_law(c));
    s = dem::MixedCrack<double>::without_bond(s);
    CHECK(dem::damage(dem::crack_law(c), s) == 1.0);
    const auto u = dem::advance(dem::crack_law(c), dem::mixed_law(c), s, 1e-6, 1e-6);
    CHECK(u.state.sigma == 0.0);
    CHECK(u.state.tau == 0.0);
}

TEST_CASE("mixed wall: what the law does not know is refused", "[dem][mixed_wall]")
{
    scenes::Scene s = small_wall::scene();
    dem::Model m = small_wall::model(s);
    m.layout.mixed_mode = true;
    dem::SolverOptions o;
    WallMaterials w = scenes::uniform(s, m);
    std::string message;
    SECTION("uncoupled")
    {
        o.law = dem::ContactLaw::uncoupled;
        message = "the law of mixed modes is coupled";
    }
    SECTION("elastic unloading")
    {
        o.unloading = dem::Unloading::elastic;
        message = "unloads in tension to the origin";
    }
    SECTION("negative energy")
    {
        w.cracks[2].shear_fracture_energy = -1.0;
        message = "crack 3: the fracture energy in shear must not be negative";
    }
    SECTION("an energy without the law")
    {
        m.layout.mixed_mode = false;
        w.cracks[2].shear_fracture_energy = 100.0;
        message = "crack 3: a hyperbolic envelope and a fracture energy in shear need";
    }
    SECTION("an envelope without the law")
    {
        m.layout.mixed_mode = false;
        w.joints[1].envelope = Envelope::hyperbolic;
        message = "joint 2: a hyperbolic envelope";
    }
    CHECK_THROWS_WITH(dem::push(m, w, small_wall::to(1e-5), o), Catch::Contains(message));
    CHECK_THROWS_WITH(pushed(m, {w}, small_wall::to(1e-5), o), Catch::Contains(message));
}
