/// Rigid-block limits: problems 17, 18 and 19 of the verification list.

#include "dem/block/model.hpp"
#include "dem/solver/step/step.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kDensity = 2700.0; // of problems 18 and 19 [kg/m3]
constexpr double kMu = 0.62;

dem::Discretisation rigid_blocks(int contact_points = 2)
{
    dem::Discretisation d;
    d.contact_points = contact_points;
    d.block_modes = 3;
    d.zones_per_interval = 1;
    d.beam_modes = 3;
    return d;
}

/// The paper's wall as rigid blocks on a first course that can lift, joints a hundred times
/// stiffer than real.
scenes::Scene rigid_wall(double load_kn, bool units_intact)
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.base = dem::Base::joint;
    s.wall.toe = dem::Toe::free;
    s.beam.interface = dem::BeamInterface::joint;
    s.stone.density = kDensity;
    s.beam.material.density = 0.0;
    s.loads.vertical_stress = load_kn * 1e3 / 0.20;
    s.joint.kn *= 100.0;
    s.joint.ks *= 100.0;
    s.joint.tan_phi = kMu;
    s.crack.kn = s.joint.kn;
    s.crack.ks = s.joint.ks;
    s.crack.ft = s.crack.cohesion = units_intact ? 1e12 : 0.0;
    s.crack.tan_phi = s.crack.tan_phi_res = kMu;
    return s;
}

/// Force once the mechanism has formed: the last point of a push that small displacements leave
/// level [N].
double plateau(const scenes::Scene& s)
{
    const dem::Model m = scenes::model_of(s, rigid_blocks());
    dem::PushPlan plan;
    plan.targets = {2e-3};
    dem::SolverOptions slow; // stiff joints: the mechanism forms within microns
    slow.accuracy = 0.001;
    return dem::push(m, scenes::uniform(s, m), plan, slow).curve.back().force;
}

} // namespace

TEST_CASE("limit load: a rocking block on an elastic joint carries N (L/2 - c/3)/h, c its "
          "compressed length",
          "[dem][limit_load][slow]")
{
    const double stress = GENERATE(0.15e6, 0.5e6, 1.25e6), displacement = GENERATE(4e-3, 16e-3);
    const double kn = 1e10, length = 1.0, height = 1.0, t = 0.2;
    scenes::Scene s = scenes::monolith(length, height, stress, kn);
    s.stone.young_modulus = s.beam.material.young_modulus = 1e15;
    dem::Discretisation d = rigid_blocks(33);
    const dem::Model m = scenes::model_of(s, d);
    dem::PushPlan plan;
    plan.targets = {displacement};
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan);

    const double n = stress * length * t + s.stone.density * 9.81 * length * height * t;
    const double h = s.loads.height;
    // The beam joint turns too: it stays closed, elastic rotation M/(kn I), M = V (h - height).
    const double second_moment = t * std::pow(length, 3) / 12.0;
    const double v = r.curve.back().force;
    const double beam_turn = v * (h - height) / (kn * second_moment);
    const double shear = v / (s.joint.ks * length * t);
    const double sheared_beam = 2.0 * shear; // base and beam joint
    const double theta = (displacement - sheared_beam - beam_turn * (h - height)) / h;
    const double c = std::sqrt(2.0 * n / (kn * theta * t));
    REQUIRE(c < length);
    CHECK(v == Approx(n * (length / 2 - c / 3) / h).epsilon(0.01));
    CHECK(v < n * length / (2 * h));
}

TEST_CASE("limit load: the paper's wall stays under the monolithic rocking and sliding bounds",
          "[dem][limit_load][slow]")
{
    // Problem 19: (N + W) L / (2 h) and mu (N + W), W = 5.297 kN.
    const auto [load, rocking, sliding] =
        GENERATE(table<double, double, double>({{30, 16.04, 21.9},
                                                {100, 47.86, 65.3},
                                                {150, 70.59, 96.3},
                                                {200, 93.32, 127.3},
                                                {250, 116.04, 158.3}}));
    const double weight = kDensity * 9.81 * 0.2 * 1e-3;
    CHECK((load + weight) * 0.5 / 1.1 == Approx(rocking).epsilon(3e-4));
    CHECK(kMu * (load + weight) == Approx(sliding).epsilon(3e-3));
    CHECK(plateau(rigid_wall(load, true)) < rocking * 1e3);
}

TEST_CASE(
    "limit load: the paper's wall of rigid units approaches the limit analysis from below",
    "[dem][limit_load][slow]")
{
    // Problem 18, associated flow: units intact, and all cracked beforehand. Cracked units
    // leave columns of half units; what holds these together in the limit analysis is dilatancy
    // alone, so far less is carried without it. Columns that rock one by one are the least: (N
    // + W) b / (2 h).
    const auto [load, intact, cracked] = GENERATE(table<double, double, double>(
        {{30, 14.90, 8.55}, {100, 46.72, 27.40}, {250, 114.90, 67.76}}));
    const double whole = plateau(rigid_wall(load, true)) * 1e-3;
    const double halves = plateau(rigid_wall(load, false)) * 1e-3;
    WARN("N = " << load << " kN: " << whole / intact
                << " of the associated limit with units intact, " << halves / cracked
                << " with all of them cracked");
    CHECK(whole < intact);
    CHECK(whole > 0.99 * intact);
    CHECK(halves < cracked);
    CHECK(halves > (load + kDensity * 9.81 * 0.2e-3) * 0.05 / 1.1);
}

namespace {

/// Ferris and Tin-Loi (2001): units 0.4 x 0.175, friction 0.65, no beam load, horizontal force
/// = lambda x weight.
scenes::Scene ferris_wall(int units, int courses)
{
    scenes::Scene s = scenes::paper_wall(0.50);
    s.wall.unit_length = 0.4;
    s.wall.course_height = 0.175;
    s.wall.length = 0.4 * units;
    s.wall.courses = courses;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.wall.first_course = dem::FirstCourse::shifted;
    s.wall.base = dem::Base::joint;
    s.wall.toe = dem::Toe::free;
    s.beam.interface =
        dem::BeamInterface::joint; // weightless on a joint without friction: it is not there
    s.beam.material.density = 0.0;
    s.loads.vertical_stress = 0.0;
    s.loads.height = s.wall.courses * s.wall.course_height + s.beam.height;
    s.joint.kn = 1e12;
    s.joint.ks = 4e11;
    s.joint.tan_phi = 0.65;
    return s;
}

/// A wall under self-weight and a share lambda of it sideways.
struct Tilted {
    dem::Model model;
    dem::StepTables tables;
    dem::SolverOptions options;
    dem::WallState<double> state;
    std::vector<double> upright;

    explicit Tilted(const scenes::Scene& s)
        : model(scenes::model_of(s, rigid_blocks())), tables(dem::step_tables(model))
    {
        dem::WallMaterials w = scenes::uniform(s, model);
        w.beam_joint.tan_phi = 0.0;
        state = dem::unloaded<double>(model, tables, {&w, 1}, options);
        upright = state.laws.load;
    }
    void lean(double lambda)
    {
        for (std::size_t b = 0; b < tables.blocks.size(); ++b)
            if (static_cast<int>(b) != model.layout.beam)
                for (int i = 0; i < tables.blocks[b].modes; ++i) {
                    const int mode = tables.blocks[b].first_mode + i;
                    const double pull = model.elements[tables.blocks[b].element].sway(i) *
                                        model.stone.density * 9.81;
                    state.laws.load[mode] = upright[mode] + lambda * pull;
                }
    }
    /// Whether the wall comes to rest.
    bool stands(double load_factor, int most_steps)
    {
        dem::StepInput<double> in;
        in.load_factor = load_factor;
        for (int i = 0; i < most_steps; ++i) {
            dem::step(tables, options, in, state);
            if (i % 200 == 199 && dem::unbalanced_ratio(state, 0) < 1e-6) return true;
        }
        return false;
    }
};

/// Largest lambda at which the wall stands, to `tolerance`.
double tilt_limit(const scenes::Scene& s, double tolerance)
{
    Tilted wall(s);
    for (int i = 1; i <= 20; ++i) wall.stands(i / 20.0, 400);
    REQUIRE(wall.stands(1.0, 200000));
    double stands = 0.0, step = 0.05;
    while (step > tolerance) {
        const dem::WallState<double> kept = wall.state;
        wall.lean(stands + step);
        if (wall.stands(1.0, 60000)) {
            stands += step;
        } else {
            wall.state = kept;
            step *= 0.5;
        }
    }
    return stands;
}

} // namespace

TEST_CASE("limit load: the walls of Ferris and Tin-Loi fall below the associated limit",
          "[dem][limit_load][slow]")
{
    // Problem 17: 0.64286 (5 x 6) and 0.58000 (5 x 10), which assume dilatancy tan(psi) = mu;
    // ours is 0.
    const auto [courses, limit] = GENERATE(table<int, double>({{6, 0.64286}, {10, 0.58000}}));
    const double lambda = tilt_limit(ferris_wall(5, courses), 5e-4);
    WARN("5 x " << courses << ": lambda " << lambda << ", " << lambda / limit
                << " of the associated limit");
    CHECK(lambda < limit);
    CHECK(lambda > 0.85 * limit);
}
