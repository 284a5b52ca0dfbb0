#include "dem/scene/mechanism/mechanism.hpp"
#include "scenes/snapshot_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <utility>

namespace {

using dem::FaceKind;
using dem::FailureMode;
using dem::Mechanism;
using dem::ModeRule;
using dem::ModeThresholds;
using dem::Point;
using dem::Snapshot;

constexpr double kLength = 0.8, kCourse = 0.2,
                 kTop = 0.8; // three courses and the beam; load line on its top [m]

/// One block per course and the beam above, each moved as `motion` says; all joints closed.
Snapshot stack(const std::function<Point(int course, Point at)>& motion, double displacement)
{
    Snapshot s;
    s.displacement = displacement;
    for (int course = 1; course <= 4; ++course) {
        const double z0 = (course - 1) * kCourse, z1 = course * kCourse;
        dem::BlockState b;
        b.course = course % 4;
        b.unit = course % 4;
        b.outline = {{0, z0}, {kLength, z0}, {kLength, z1}, {0, z1}};
        for (const Point p : b.outline) b.displacement.push_back(motion(course, p));
        s.blocks.push_back(b);
        dem::FaceState f;
        f.kind = course == 1   ? FaceKind::base_joint
                 : course == 4 ? FaceKind::beam_joint
                               : FaceKind::bed_joint;
        f.normal = {0, 1};
        f.block_a = course - 2;
        f.block_b = course - 1;
        for (const double x : {0.0, kLength}) {
            const Point below = course == 1 ? Point{} : motion(course - 1, {x, z0}),
                        above = motion(course, {x, z0});
            dem::ContactState c;
            c.at = {x, z0};
            c.area = 0.1;
            c.opening = above.z - below.z;
            c.slip = above.x - below.x;
            c.sigma = c.opening > 0.0 ? 0.0 : -1e6;
            f.contacts.push_back(c);
        }
        s.faces.push_back(f);
    }
    return s;
}

/// The courses from `first` on turn about (kLength, z of their base).
Snapshot rocking(int first, double displacement)
{
    const double hinge = (first - 1) * kCourse, theta = displacement / (kTop - hinge);
    return stack(
        [=](int course, Point p) {
            return course < first ? Point{}
                                  : Point{theta * (p.z - hinge), theta * (kLength - p.x)};
        },
        displacement);
}

/// Puts a unit of two pieces under the beam, with a crack of so many contacts between them.
/// @param left share of the unit that lies left of the crack
void crack_unit(Snapshot& s, int broken_contacts, int contacts = 4, double left = 0.5)
{
    const int first = static_cast<int>(s.blocks.size()) - 1; // where the beam was
    for (dem::FaceState& f : s.faces)
        for (int* block : {&f.block_a, &f.block_b})
            if (*block >= first) *block += 2;
    const double cut = left * kLength;
    for (const auto& [x0, x1] : {std::pair{0.0, cut}, std::pair{cut, kLength}}) {
        dem::BlockState piece;
        piece.course = 3;
        piece.unit = 100 + first;
        piece.outline = {{x0, 0}, {x1, 0}, {x1, kCourse}, {x0, kCourse}};
        piece.displacement.resize(4);
        s.blocks.insert(s.blocks.end() - 1, piece);
    }
    dem::FaceState f;
    f.kind = FaceKind::unit_crack;
    f.block_a = first;
    f.block_b = first + 1;
    f.contacts.resize(contacts);
    for (int i = 0; i < broken_contacts; ++i) f.contacts[i].damage = 1.0;
    s.faces.push_back(f);
}

FailureMode mode_of(const Snapshot& s, bool dropped = false)
{
    return dem::failure_mode(dem::mechanism(s, kTop), dropped);
}

} // namespace

TEST_CASE("mechanism: a wall that turns about its toe rocks and nothing else",
          "[dem][mechanism]")
{
    const double displacement = GENERATE(1e-3, 0.03, -0.02);
    const Snapshot s = rocking(1, displacement);
    const Mechanism m = dem::mechanism(s, kTop);
    CHECK(m.rotation_share == Approx(1.0).epsilon(1e-12));
    CHECK(std::abs(m.sliding_share) < 1e-12);
    CHECK(m.cracked_units == 0);
    CHECK(m.cracked_contacts == 0);
    CHECK(mode_of(s) == FailureMode::rocking);
}

TEST_CASE(
    "mechanism: above a base that stays, rotation counts with the height of the load line",
    "[dem][mechanism]")
{
    // Turning about the top of the first course: theta = d/(h - 0.2)
    CHECK(dem::mechanism(rocking(2, 0.01), kTop).rotation_share ==
          Approx(kTop / (kTop - kCourse)).epsilon(1e-12));
}

TEST_CASE(
    "mechanism: an arch whose parts turn to both sides rocks, one whose joint slides does "
    "not",
    "[dem][mechanism]")
{
    // Two voussoirs side by side, without a beam, turn against each other about the floor.
    const double displacement = GENERATE(0.01, -0.01), theta = displacement / kTop;
    Snapshot s = stack([](int, Point) { return Point{}; }, displacement);
    s.blocks.resize(2);
    s.faces.clear();
    for (int i = 0; i < 2; ++i) {
        dem::BlockState& b = s.blocks[i];
        const double x = i * kLength, turn = i == 0 ? theta : -theta;
        b.course = 1;
        b.unit = i + 1;
        b.outline = {{x, 0}, {x + kLength, 0}, {x + kLength, kTop}, {x, kTop}};
        b.displacement.clear();
        for (const Point p : b.outline)
            b.displacement.push_back({turn * p.z, turn * (x + 0.5 * kLength - p.x)});
    }
    const Mechanism m = dem::mechanism(s, kTop);
    CHECK(std::abs(m.rotation_share) < 1e-12);
    CHECK(std::abs(m.sliding_share) < 1e-12);
    CHECK(m.turning_share == Approx(1.0).epsilon(1e-12));
    CHECK(mode_of(s) == FailureMode::rocking);

    CHECK(dem::mechanism(s, 0.5 * kTop).turning_share ==
          m.turning_share); // the load lies lower

    dem::FaceState f; // the same, but a bed joint has slid as far
    f.kind = FaceKind::base_joint;
    f.block_a = -1;
    f.block_b = 0;
    f.contacts.resize(1);
    f.contacts[0].area = 0.1;
    f.contacts[0].sigma = -1e6;
    f.contacts[0].slip = displacement;
    s.faces.push_back(f);
    CHECK(std::abs(dem::mechanism(s, kTop).turning_share) < 1e-12);
    CHECK(mode_of(s) == FailureMode::sliding);
}

TEST_CASE("mechanism: a course that slides carries the whole displacement on one joint",
          "[dem][mechanism]")
{
    const int first = GENERATE(1, 2, 3, 4); // base joint, bed joints, beam joint
    const double displacement = GENERATE(1e-3, -0.02);
    const Snapshot s = stack(
        [=](int course, Point) {
            return course < first ? Point{} : Point{displacement, 0};
        },
        displacement);
    const Mechanism m = dem::mechanism(s, kTop);
    CHECK(m.sliding_share == Approx(1.0).epsilon(1e-12));
    CHECK(m.rotation_share == 0.0);
    CHECK(std::abs(m.turning_share) < 1e-12);
    CHECK(mode_of(s) == FailureMode::sliding);
    CHECK(dem::failure_mode(m, false, {0.5, 1, ModeRule::paper}) == FailureMode::rocking);
    CHECK(dem::failure_mode(m, false, {0.5, 0}) == FailureMode::mixed);
}

TEST_CASE("mechanism: a wall that turns below a beam that does not, in double bending, rocks",
          "[dem][mechanism]")
{
    const double d = GENERATE(1e-3, -0.02), theta = d / (3 * kCourse);
    const Snapshot s = stack(
        [=](int course, Point p) {
            return course == 4 ? Point{d, 0} : Point{theta * p.z, theta * (kLength - p.x)};
        },
        d);
    const Mechanism m = dem::mechanism(s, kTop);
    CHECK(std::abs(m.rotation_share) < 1e-12); // the beam's
    CHECK(m.turning_share == Approx(1.0).epsilon(1e-12));
    CHECK(mode_of(s) == FailureMode::rocking);
    CHECK(dem::failure_mode(m, false, {0.5, 0}) ==
          FailureMode::mixed); // cracked, and it does not overturn
}

TEST_CASE("mechanism: piers that turn between a base and a spandrel that do not rock",
          "[dem][mechanism]")
{
    const double d = GENERATE(1e-3, -0.02), theta = d / kCourse;
    const Snapshot s = stack(
        [=](int course, Point p) {
            if (course == 1) return Point{};
            return course == 2 ? Point{theta * (p.z - kCourse), theta * (kLength - p.x)}
                               : Point{d, 0};
        },
        d);
    CHECK(dem::mechanism(s, kTop).turning_share == Approx(1.0).epsilon(1e-12));
    CHECK(mode_of(s) == FailureMode::rocking);
}

TEST_CASE("mechanism: stones that stay behind say nothing of those that turn",
          "[dem][mechanism]")
{
    const Mechanism stair = dem::mechanism(scenes::stair_step_rocking(0.02), 1.1);
    CHECK(stair.turning_share ==
          Approx(10.0 / 11.0)); // the lowest of eleven levels stays whole
    CHECK(dem::mechanism(scenes::stair_step_rocking(-0.02), 1.1).turning_share ==
          Approx(stair.turning_share).epsilon(1e-12));
}

TEST_CASE("mechanism: without a beam the blocks tell the rotation, not the last of them",
          "[dem][mechanism]")
{
    Snapshot s = rocking(1, 0.01);
    s.blocks.pop_back();
    s.faces.pop_back();
    for (Point& p : s.blocks.back().displacement)
        p = {0.01, 0.0}; // the top course slides along
    const Mechanism m = dem::mechanism(s, kTop);
    CHECK(m.rotation_share == m.turning_share);
    CHECK(m.rotation_share ==
          Approx(0.5).epsilon(1e-12)); // two courses of 0.2 m turn by d/0.8 m
}

TEST_CASE("mechanism: a wall that slid and then turned is read by how it moves now",
          "[dem][mechanism]")
{
    const auto slid_by = [](double slip, Point p, double theta) {
        return Point{slip + theta * p.z, theta * (kLength - p.x)};
    };
    const double slip = 0.03, theta = 0.02 / kTop; // slides 30 mm, and then turns by 20 mm more
    const auto wall = [&](double turned) {
        return stack([&](int, Point p) { return slid_by(slip, p, turned); },
                     slip + turned * kTop);
    };
    const Snapshot early = wall(0.0), late = wall(theta);
    CHECK(mode_of(early) == FailureMode::sliding);
    CHECK(mode_of(late) == FailureMode::sliding); // 0.4 of all of its movement
    const Mechanism since = dem::mechanism(dem::movement_since(early, late), kTop);
    CHECK(since.rotation_share == Approx(1.0).epsilon(1e-12));
    CHECK(since.turning_share == Approx(1.0).epsilon(1e-12));
    CHECK(std::abs(since.sliding_share) < 1e-12);
    CHECK(mode_of(dem::movement_since(early, late)) == FailureMode::rocking);
}

TEST_CASE("mechanism: slips of the courses add up", "[dem][mechanism]")
{
    const double d = 0.01;
    const Snapshot s = stack([d](int course, Point) { return Point{0.25 * d * course, 0}; }, d);
    CHECK(dem::mechanism(s, kTop).sliding_share == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("mechanism: a course slides by the mean of what is closed, by area",
          "[dem][mechanism]")
{
    Snapshot s = rocking(1, 0.01);
    auto& contacts = s.faces[1].contacts;
    contacts.resize(3, contacts[0]);
    contacts[0].slip = 0.001;
    contacts[0].area = 0.1;
    contacts[1].slip = 0.005;
    contacts[1].area = 0.3;
    contacts[2].slip = 0.009;
    for (auto& c : contacts) c.sigma = -1.0;
    contacts[2].sigma = 0.0; // open: its parts move apart freely
    CHECK(dem::mechanism(s, kTop).sliding_share ==
          Approx((0.1 * 0.001 + 0.3 * 0.005) / 0.4 / 0.01).epsilon(1e-12));
}

TEST_CASE("mechanism: the pieces of a bed joint are one joint", "[dem][mechanism]")
{
    Snapshot s = stack(
        [](int course, Point) {
            return course < 2 ? Point{} : Point{0.01, 0};
        },
        0.01);
    dem::FaceState left = s.faces[1], right = s.faces[1];
    left.contacts.pop_back();
    right.contacts.erase(right.contacts.begin());
    right.contacts[0].at.z += 1e-9; // rounding of heights
    s.faces[1] = left;
    s.faces.push_back(right);
    CHECK(dem::mechanism(s, kTop).sliding_share == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("mechanism: slip in head joints and unit cracks is not sliding of courses",
          "[dem][mechanism]")
{
    Snapshot s = rocking(1, 0.01);
    s.faces[1].kind = GENERATE(FaceKind::head_joint, FaceKind::unit_crack);
    for (auto& c : s.faces[1].contacts) {
        c.slip = 0.01;
        c.sigma = -1.0;
    }
    CHECK(std::abs(dem::mechanism(s, kTop).sliding_share) < 1e-12);
}

TEST_CASE("mechanism: a unit is cracked through when all its contacts are broken",
          "[dem][mechanism]")
{
    Snapshot s = rocking(1, 0.01);
    crack_unit(s, 3);
    s.faces.back().contacts[3].damage = 0.999; // hangs by a thread
    CHECK(dem::mechanism(s, kTop).cracked_units == 0);
    CHECK(dem::mechanism(s, kTop).cracked_contacts == 3);
    CHECK(mode_of(s) == FailureMode::rocking);
    crack_unit(s, 4);
    CHECK(dem::mechanism(s, kTop).cracked_units == 1);
    CHECK(dem::mechanism(s, kTop).cracked_contacts == 7);
    CHECK(mode_of(s) == FailureMode::rocking); // it still overturns
}

TEST_CASE("mechanism: a corner that breaks off a unit spalls, and does not crack it through",
          "[dem][mechanism]")
{
    Snapshot s = rocking(1, 0.01);
    crack_unit(s, 4, 4, 0.2);
    CHECK(dem::mechanism(s, kTop).cracked_units == 0);
    CHECK(dem::mechanism(s, kTop).spalled_units == 1);
    crack_unit(s, 4, 4, 0.25);
    CHECK(dem::mechanism(s, kTop).cracked_units == 1);
    CHECK(dem::mechanism(s, kTop).spalled_units == 1);
}

TEST_CASE("mechanism: a wall not pushed has no shares", "[dem][mechanism]")
{
    Snapshot s = rocking(1, 0.01);
    s.displacement = 0.0;
    const Mechanism m = dem::mechanism(s, kTop);
    CHECK(m.rotation_share == 0.0);
    CHECK(m.sliding_share == 0.0);
}

TEST_CASE("mechanism: a wall whose joints are all open does not slide", "[dem][mechanism]")
{
    Snapshot s = rocking(1, 0.01);
    for (auto& f : s.faces)
        for (auto& c : f.contacts) {
            c.sigma = 0.0;
            c.slip = 1.0;
        }
    CHECK(dem::mechanism(s, kTop).sliding_share == 0.0);
}

TEST_CASE("mechanism: as the paper reads modes, a drop makes a mode mixed, and so do cracks "
          "with little rotation",
          "[dem][mechanism]")
{
    using enum FailureMode;
    const auto rule = [](double share, int cracked) {
        return ModeThresholds{share, cracked, ModeRule::paper};
    };
    const Mechanism rocks{0.5, 0.1, 0, 5}; // half is enough
    CHECK(dem::failure_mode(rocks, false, rule(0.5, 1)) == rocking);
    CHECK(dem::failure_mode(rocks, true, rule(0.5, 1)) == mixed);
    Mechanism cracked = rocks, slid = rocks, both = rocks;
    cracked.cracked_units = both.cracked_units = 1;
    slid.rotation_share = both.rotation_share = GENERATE(0.49, -0.1);
    CHECK(dem::failure_mode(cracked, false, rule(0.5, 1)) == rocking); // damage at a corner
    CHECK(dem::failure_mode(slid, false, rule(0.5, 1)) == rocking);
    CHECK(dem::failure_mode(both, false, rule(0.5, 1)) == mixed);
    CHECK(dem::failure_mode(both, false, rule(0.5, 2)) == rocking);
    CHECK(dem::failure_mode(slid, false, rule(0.5, 0)) == mixed);
    CHECK(dem::failure_mode(cracked, false, rule(0.51, 1)) == mixed);
}

TEST_CASE(
    "mechanism: walls that turn rock whatever cracked, others are mixed where they cracked, "
    "and else slide, whether or not they lose load",
    "[dem][mechanism]")
{
    using enum FailureMode;
    const bool dropped = GENERATE(false, true);
    Mechanism rocks{0.5, 0.1, 0, 5};
    CHECK(dem::failure_mode(rocks, dropped) == rocking);
    rocks.cracked_units = 1;
    CHECK(dem::failure_mode(rocks, dropped) == rocking);
    Mechanism slides{GENERATE(0.49, -0.1), 0.9, 0, 5};
    CHECK(dem::failure_mode(slides, dropped) == sliding);
    CHECK(dem::failure_mode(slides, dropped, {0.5, 0}) == mixed);
    slides.cracked_units = 1;
    CHECK(dem::failure_mode(slides, dropped) == mixed);
    CHECK(dem::failure_mode(slides, dropped, {0.5, 2}) == sliding);
}

TEST_CASE("mechanism: a stair of opened joints rocks, a diagonal crack through units does not",
          "[dem][mechanism]")
{
    const double load_height = 1.1;
    const Mechanism stair = dem::mechanism(scenes::stair_step_rocking(0.02), load_height);
    CHECK(stair.rotation_share == Approx(1.0).epsilon(1e-12));
    CHECK(std::abs(stair.sliding_share) < 0.05);
    CHECK(stair.cracked_units == 0);
    CHECK(dem::failure_mode(stair, false) == FailureMode::rocking);

    const Mechanism diagonal = dem::mechanism(scenes::diagonal_crack(0.02, 0.6), load_height);
    CHECK(diagonal.rotation_share == Approx(0.2).epsilon(1e-12)); // the rest slides
    CHECK(diagonal.cracked_units > 0);
    CHECK(dem::failure_mode(diagonal, false) == FailureMode::mixed);

    const Mechanism rest = dem::mechanism(scenes::wall_at_rest(), load_height);
    CHECK(rest.cracked_contacts == 0);
    CHECK(dem::failure_mode(rest, false, {0.5, 1, ModeRule::paper}) == FailureMode::rocking);
}
