/// Joints that mortar bonds, against closed forms.

#include "dem/block/model.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"
#include "tests/dem/small_wall.hpp"

#include <catch2/catch.hpp>

namespace {

/// Two squat courses of one unit each, the lower one held; small strains, no rocking.
scenes::Scene two_courses(double stress)
{
    scenes::Scene s = scenes::monolith(1.0, 0.1, stress, 1e10);
    s.wall.courses = 2;
    s.wall.base = dem::Base::fixed;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.loads.height = 0.2;
    s.joint.tan_phi = 0.5;
    return s;
}

dem::PushResult pushed(const scenes::Scene& s, bool mortar, double to)
{
    dem::Layout layout = dem::lay_out(s.wall, s.beam.height);
    layout.mortar = mortar;
    const dem::Model m =
        dem::discretise(layout, s.stone, s.beam, s.loads, {s.joint, s.crack}, {});
    dem::PushPlan plan;
    plan.targets = {to};
    plan.record_every = to / 200;
    dem::SolverOptions o;
    o.accuracy = 0.001;
    return dem::push(m, scenes::uniform(s, m), plan, o);
}

double area(const scenes::Scene& s) { return s.wall.length * s.wall.thickness; }

/// Vertical force in the bed joint [N].
double vertical(const scenes::Scene& s)
{
    const double above =
        s.stone.density * s.wall.course_height + s.beam.material.density * s.beam.height;
    return area(s) * (s.loads.vertical_stress + above * s.loads.gravity);
}

} // namespace

TEST_CASE("mortar: a bed joint shears where its end has c + sigma tan(phi), then slides at N "
          "tan(phi)",
          "[dem][mortar]")
{
    scenes::Scene s = two_courses(0.4e6);
    s.joint.cohesion = 0.2e6;
    const dem::PushResult r = pushed(s, true, 1e-3);
    const double bond = s.joint.cohesion * area(s), slides = vertical(s) * s.joint.tan_phi;
    // The moment of V about the joint, 0.1 m below, relieves one end: V/A = c + (N/A - 6 V h/(t
    // L^2)) tan(phi).
    const double shears = (bond + slides) / (1.0 + 6.0 * 0.1 * s.joint.tan_phi / s.wall.length);
    CHECK(r.residual < 0.01);
    CHECK(scenes::peak_force(r) == Approx(shears).epsilon(0.01));
    CHECK(r.curve.back().force == Approx(slides).epsilon(0.01));
    CHECK(r.energy.fracture > 0.0);
}

TEST_CASE("mortar: without strength a bonded joint is a dry joint", "[dem][mortar]")
{
    const scenes::Scene s = two_courses(0.4e6);
    const dem::PushResult dry = pushed(s, false, 1e-3), none = pushed(s, true, 1e-3);
    CHECK(scenes::peak_force(none) == Approx(scenes::peak_force(dry)).epsilon(2e-3));
}

TEST_CASE("mortar: bond holds a wall down that rocks when dry, by f_t at the edge",
          "[dem][mortar]")
{
    // A stiff slender wall on a brittle bond: V h = (N/A + f_t) t L^2/6 where the edge breaks.
    scenes::Scene s = two_courses(0.1e6);
    s.wall.length = 0.2;
    s.wall.course_height = 0.5;
    s.wall.unit_length = 0.2;
    s.beam.height = 0.1;
    s.loads.height = 1.1;
    s.joint.tan_phi = 5.0;
    s.joint.ft = 0.5e6;
    s.joint.cohesion = 5e6;
    const dem::PushResult r = pushed(s, true, 1e-3);
    const double l = s.wall.length;
    const double cracks =
        (vertical(s) / area(s) + s.joint.ft) * s.wall.thickness * l * l / 6.0 / 0.6;
    CHECK(scenes::peak_force(r) > 0.95 * cracks);
    CHECK(scenes::peak_force(r) <
          1.4 * cracks); // the stress redistributes while the bond softens
    s.joint.ft = s.joint.cohesion = 0.0;
    CHECK(scenes::peak_force(pushed(s, false, 1e-3)) < 0.5 * scenes::peak_force(r));
}

TEST_CASE("mortar: strengths without mortar in the layout are refused", "[dem][mortar]")
{
    scenes::Scene s = two_courses(0.4e6);
    s.joint.cohesion = 0.2e6;
    CHECK_THROWS_WITH(pushed(s, false, 1e-3), Catch::Contains("need a layout with mortar"));
}
