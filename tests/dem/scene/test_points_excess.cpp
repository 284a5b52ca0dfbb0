/// Error of the force by few contact points, against joints that press along all of a face.

#include "dem/block/model.hpp"
#include "dem/scene/mechanism/points_excess.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kKn = 1e10, kLength = 1.0, kThickness = 0.2; // [Pa/m] [m] [m]

/// A face turned by theta about a place `closed` from its first end, on even points.
dem::FaceState rocking_face(int points, double theta, double closed)
{
    dem::FaceState f;
    f.normal = f.acting = {0.0, 1.0};
    for (int i = 0; i < points; ++i) {
        const bool end = i == 0 || i == points - 1;
        dem::ContactState c;
        c.at = {kLength * i / (points - 1), 0.0};
        c.area = (end ? 0.5 : 1.0) * kLength * kThickness / (points - 1);
        c.opening = theta * (c.at.x - closed);
        c.sigma = kKn * std::min(0.0, c.opening);
        f.contacts.push_back(c);
    }
    return f;
}

double thrust(const dem::FaceState& f)
{
    double n = 0.0;
    for (const dem::ContactState& c : f.contacts) n -= c.sigma * c.area;
    return n;
}

/// A block of 1 m x 1 m that cannot deform, pushed on joints of 10 GPa/m.
struct Rocking {
    double force, exact, excess; ///< [N]
};
Rocking rocking(int points, double stress, double displacement)
{
    scenes::Scene s = scenes::monolith(kLength, 1.0, stress, kKn);
    s.stone.young_modulus = s.beam.material.young_modulus = 1e15;
    dem::Discretisation d;
    d.contact_points = points;
    d.block_modes = d.beam_modes = 3;
    d.zones_per_interval = 1;
    d.face_rule = dem::FaceRule::even;
    const dem::Model m = scenes::model_of(s, d);
    dem::PushPlan plan;
    plan.targets = {displacement};
    dem::SolverOptions slow;
    slow.accuracy = 0.002;
    const dem::PushResult r = dem::push(m, scenes::uniform(s, m), plan, slow);

    // As in the test of the rocking block on an elastic joint (test_limit_load.cpp).
    const double n = stress * kLength * kThickness + s.stone.density * 9.81 * kThickness;
    const double h = s.loads.height, v = r.at_end.force,
                 beam_turn = v * (h - 1.0) / (kKn * kThickness / 12.0),
                 sheared = 2.0 * v / (s.joint.ks * kLength * kThickness),
                 theta = (r.at_end.displacement - sheared - beam_turn * (h - 1.0)) / h,
                 c = std::sqrt(2.0 * n / (kKn * theta * kThickness));
    return {v, n * (kLength / 2 - c / 3) / h, dem::points_excess(r.at_end)};
}

} // namespace

TEST_CASE(
    "points excess: a face that rocks about its first end counts the couple of its points",
    "[dem][points_excess]")
{
    const int points = GENERATE(3, 5, 9);
    const double closed = GENERATE(0.05, 0.2, 0.45), theta = 0.01, pushed = 0.02;
    dem::Snapshot s;
    s.displacement = pushed;
    s.faces = {rocking_face(points, theta, closed)};
    const dem::FaceState& f = s.faces.front();
    const double n = thrust(f);
    double first = 0.0;
    for (const dem::ContactState& c : f.contacts) first -= c.sigma * c.area * c.at.x;
    const double length = std::sqrt(2.0 * n / (kKn * theta * kThickness)); // that n compresses
    CHECK(dem::points_excess(s) ==
          Approx((n * length / 3 - first) * theta / pushed).epsilon(1e-9));
}

TEST_CASE("points excess: on a face with many points nothing is left", "[dem][points_excess]")
{
    dem::Snapshot s;
    s.displacement = 0.02;
    s.faces = {rocking_face(1001, 0.01, 0.3)};
    CHECK(std::abs(dem::points_excess(s)) < 1e-5 * thrust(s.faces.front()));
}

TEST_CASE(
    "points excess: only dry faces that are partly open have any, and only of a wall that "
    "has moved",
    "[dem][points_excess]")
{
    dem::Snapshot s;
    s.displacement = 0.02;
    s.faces = {rocking_face(5, 0.01, 0.1)};
    REQUIRE(dem::points_excess(s) != 0.0);
    SECTION("not pushed") { s.displacement = 0.0; }
    SECTION("closed all along") { s.faces = {rocking_face(5, 0.01, 1.5)}; }
    SECTION("open all along") { s.faces = {rocking_face(5, 0.01, -0.5)}; }
    SECTION("holds tension") { s.faces.front().contacts.back().sigma = 1e3; }
    SECTION("crushed") { s.faces.front().contacts.front().crushed = 1e-4; }
    CHECK(dem::points_excess(s) == 0.0);
}

TEST_CASE(
    "points excess: a rocking block less its excess carries what one on continuous joints "
    "carries",
    "[dem][points_excess][slow]")
{
    const int points = GENERATE(5, 9);
    const double stress = GENERATE(0.15e6, 0.5e6), displacement = GENERATE(4e-3, 16e-3);
    const Rocking r = rocking(points, stress, displacement);
    INFO("force " << r.force << ", exact " << r.exact << ", excess " << r.excess);
    CHECK(r.force - r.excess == Approx(r.exact).epsilon(5e-3));
}
