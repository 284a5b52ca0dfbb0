/// Walls that horizontal forces in proportion to their weight push, against closed forms and
/// published values.

#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

using dem::Kinematics;

dem::Discretisation two_points()
{
    dem::Discretisation d;
    d.contact_points = 2;
    d.block_modes = 3;
    d.zones_per_interval = 1;
    return d;
}

/// A wall alone, without beam, under its own weight.
scenes::Scene alone(double length, double course_height, int courses, double tan_phi)
{
    scenes::Scene s = scenes::monolith(length, course_height, 0.0, 1e10);
    s.wall.courses = courses;
    s.wall.toe = dem::Toe::free;
    s.beam.present = false;
    s.loads.pattern = dem::LoadPattern::body;
    s.joint.tan_phi = tan_phi;
    return s;
}

dem::PushResult pushed(const scenes::Scene& s, Kinematics k, double to, double accuracy)
{
    const dem::Model m = scenes::model_of(s, two_points());
    dem::PushPlan plan;
    plan.targets = {to};
    plan.decided = [](std::span<const dem::CurvePoint> c) {
        return c.back().force < 0.0 && c.size() > 10;
    };
    dem::SolverOptions o;
    o.kinematics = k;
    o.accuracy = accuracy;
    return dem::push(m, scenes::uniform(s, m), plan, o);
}

/// Load factor where the upper right corner has moved by `corner` [m].
double factor_at(const dem::PushResult& r, double corner)
{
    const auto above = std::find_if(r.curve.begin() + 1, r.curve.end(),
                                    [&](const auto& p) { return p.corner >= corner; });
    REQUIRE(above != r.curve.end());
    return above->force / r.weight;
}

double peak_factor(const dem::PushResult& r) { return scenes::peak_force(r) / r.weight; }

} // namespace

TEST_CASE(
    "body forces: a block that rocks carries tan(alpha - th) of its weight until its centre "
    "stands over its toe",
    "[dem][body_forces]")
{
    const double b = 0.2, h = 1.0, alpha = std::atan(b / h);
    const dem::PushResult r = pushed(alone(b, h, 1, 10.0), Kinematics::finite, 0.12, 0.01);
    CHECK(r.residual < 0.01);
    CHECK(peak_factor(r) == Approx(b / h).epsilon(5e-3));
    for (const double th : {0.02, 0.05, 0.1, 0.15}) {
        INFO("rotation " << th);
        CHECK(factor_at(r, h * std::sin(th)) == Approx(std::tan(alpha - th)).margin(1e-3));
    }
    CHECK(r.curve.back().force < 0.0);
    CHECK(r.curve.back().corner == Approx(h * std::sin(alpha)).epsilon(5e-3));
}

TEST_CASE(
    "body forces: a block that slides carries tan(phi) of its weight, with small displacements "
    "as with finite ones",
    "[dem][body_forces]")
{
    const Kinematics k = GENERATE(Kinematics::small, Kinematics::finite);
    const dem::PushResult r = pushed(alone(1.0, 0.5, 1, 0.3), k, 2e-3, 0.001);
    CHECK(r.curve.back().force / r.weight == Approx(0.3).epsilon(2e-3));
    CHECK(r.curve.back().base_shear == Approx(r.curve.back().force).epsilon(2e-3));
    CHECK(r.curve.back().corner == Approx(2e-3).epsilon(0.03));
    CHECK(r.residual < 0.01);
}

TEST_CASE("body forces: the beam moves with the wall and adds its own weight",
          "[dem][body_forces]")
{
    scenes::Scene s = alone(1.0, 0.9, 1, 10.0);
    s.beam.present = true;
    s.beam.material.density = 3.0 * s.stone.density;
    const dem::PushResult r = pushed(s, Kinematics::small, 4e-3, 0.001);
    // The block of 0.9 m and the beam of 0.1 m weigh 3 : 1; together they rock about the toe.
    const double centre = (0.45 * 3.0 + 0.95) / 4.0;
    CHECK(r.weight == Approx(s.stone.density * 9.81 * 0.2 * 1.2).epsilon(1e-12));
    CHECK(peak_factor(r) == Approx(0.5 / centre).epsilon(0.01));
}

TEST_CASE("body forces: what has no weight cannot be pushed by them", "[dem][body_forces]")
{
    scenes::Scene s = alone(1.0, 0.9, 1, 10.0);
    s.stone.density = 0.0;
    CHECK_THROWS_WITH(scenes::model_of(s, two_points()),
                      Catch::Contains("density and gravity"));
    s.stone.density = 2000.0;
    s.loads.gravity = 0.0;
    CHECK_THROWS_WITH(scenes::model_of(s, two_points()),
                      Catch::Contains("density and gravity"));
}

// Portioli (2020) and Portioli et al. (2021), read off a figure: 0.64 at 0, 0.56 at 0.06 m,
// 0.49 at 0.10 m, zero at 0.37 m. tests/dem/sequential_limit.py, rigid blocks by linear
// programming in steps of 0.1 mm: 0.643, 0.556, 0.505, at 0.20 m 0.359, zero at 0.404 m.
TEST_CASE("body forces: wall 1 of Ferris and Tin-Loi loses its load as published up to 0.1 m, "
          "and beyond as rigid blocks do",
          "[dem][body_forces][slow]")
{
    scenes::Scene s = alone(2.0, 0.175, 6, 0.65);
    s.wall.unit_length = 0.4;
    s.wall.bond_offset = 0.5;
    s.wall.first_course = dem::FirstCourse::shifted;
    s.joint.kn = 1e10; // a fifth of it ends at 0.425 m
    s.joint.ks = 4e9;
    const dem::PushResult r = pushed(s, Kinematics::finite, 0.3, 0.001);
    CHECK(r.residual < 0.01);
    INFO("peak " << peak_factor(r) << ", at 0.06, 0.10, 0.20, 0.30 m " << factor_at(r, 0.06)
                 << " " << factor_at(r, 0.10) << " " << factor_at(r, 0.20) << " "
                 << factor_at(r, 0.30) << ", zero at " << r.curve.back().corner << " m, steps "
                 << r.cost.steps);
    CHECK(peak_factor(r) < 0.643);
    CHECK(peak_factor(r) == Approx(0.64).margin(0.02));
    CHECK(factor_at(r, 0.06) == Approx(0.56).margin(0.01));
    CHECK(factor_at(r, 0.10) == Approx(0.49).margin(0.02));
    CHECK(factor_at(r, 0.10) == Approx(0.5048).margin(0.005));
    CHECK(factor_at(r, 0.20) == Approx(0.3594).margin(0.01));
    CHECK(r.curve.back().force < 0.0);
    CHECK(r.curve.back().corner == Approx(0.404).margin(0.02));
    CHECK(r.outcome == dem::Outcome::decided);
}

TEST_CASE("body forces: registers give the bits of walls alone", "[dem][body_forces]")
{
    const Kinematics k = GENERATE(Kinematics::small, Kinematics::finite);
    scenes::Scene s = alone(0.6, 0.1, 3, 0.6);
    s.wall.unit_length = 0.2;
    s.wall.bond_offset = 0.5;
    s.joint.kn = 1e10;
    s.joint.ks = 4e9;
    const dem::Model m = scenes::model_of(s, two_points());
    dem::PushPlan plan = small_wall::to(0.003);
    dem::SolverOptions o = small_wall::quick();
    o.kinematics = k;
    const auto material = [&](std::size_t i) -> dem::WallMaterials {
        dem::WallMaterials w = scenes::uniform(s, m);
        for (auto& j : w.joints) j.tan_phi *= 1.0 - 0.1 * static_cast<double>(i);
        return w;
    };
    std::vector<dem::PushResult> together(5);
    dem::push_ensemble(
        m,
        {5, material, [&](std::size_t i, dem::PushResult&& r) { together[i] = std::move(r); }},
        plan, o, {.threads = 1});
    for (std::size_t i = 0; i < together.size(); ++i)
        CHECK(small_wall::same(together[i], dem::push(m, material(i), plan, o)));
    CHECK_FALSE(small_wall::same(together[0], together[4]));
}
