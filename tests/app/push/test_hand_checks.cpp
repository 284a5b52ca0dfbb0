/// Remarks of a push: what its numbers do not say by themselves.

#include "app/input/wall/wall_geometry.hpp"
#include "app/push/hand_checks.hpp"
#include "app/reading/points_error.hpp"
#include "app/study/other_way.hpp"
#include "app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace {

using Overrides = std::vector<std::string>;

/// A wall that carried `peak` [N] and stood to the end of its push.
app::PushedWall pushed(double peak)
{
    app::PushedWall w;
    w.vertical_stress = 0.5e6;
    w.loads.height = 1.1;
    w.result.settled = true;
    w.result.at_end.displacement = 0.02;
    w.displacement = {0.0, 0.01, 0.02};
    w.force = {0.0, 0.5 * peak, peak};
    w.reading.peak = fragility::Peak{peak, 0.02, true};
    w.reading.ultimate = {0.02, fragility::Reading::observed, ""};
    return w;
}

/// Checks of the wall in the good study with these keys.
app::HandChecks checks_of(const Overrides& keys, const app::PushedWall& wall)
{
    const app::Study study = study_texts::read_good(keys);
    return app::hand_checks(study, app::layout_of(study, study.source), wall);
}

/// Remarks of the wall in the good study with these keys, one to a line.
std::string remarks(const app::PushedWall& wall, const Overrides& keys = {})
{
    std::string text;
    for (const std::string& r : checks_of(keys, wall).remarks) text += r + "\n";
    return text;
}

dem::FaceState face(dem::FaceKind kind, double slip, double sigma)
{
    dem::FaceState f;
    f.kind = kind;
    f.block_a = kind == dem::FaceKind::base_joint ? -1 : 0;
    f.contacts.resize(1);
    f.contacts[0].slip = slip;
    f.contacts[0].sigma = sigma;
    return f;
}

} // namespace

TEST_CASE("hand checks: a peak under a beam that does not turn is held against twice the limit",
          "[app][hand_checks]")
{
    const Overrides fixed = {"beam.rotation=fixed"};
    const double limit = *checks_of(fixed, pushed(1e3)).rocking_limit;
    const std::string high = remarks(pushed(3.0 * limit), fixed);
    CHECK_THAT(high, Catch::Contains("50.0 % above the limit of rocking in double bending"));
    CHECK_THAT(remarks(pushed(1.5 * limit), fixed), !Catch::Contains("double bending"));
    CHECK_THAT(remarks(pushed(1.5 * limit), fixed), Catch::Contains("up to twice as much"));
}

TEST_CASE(
    "hand checks: a wall that can neither rock nor slide is not said to carry twice as much",
    "[app][hand_checks]")
{
    const Overrides jammed = {"beam.rotation=fixed", "wall.base=joint", "wall.courses=1"};
    const std::string text = remarks(pushed(500e3), jammed);
    CHECK_THAT(text, Catch::Contains("nothing can rock or slide"));
    CHECK_THAT(text, !Catch::Contains("twice"));
}

TEST_CASE("hand checks: a beam that slides on the wall is remarked as the rig's limit",
          "[app][hand_checks]")
{
    app::PushedWall w = pushed(10e3);
    const Overrides on_joint = {"beam.interface=joint"};
    w.result.at_end.faces = {face(dem::FaceKind::beam_joint, -0.015, -1e6)};
    CHECK_THAT(remarks(w, on_joint),
               Catch::Contains("slid by 15.0 mm on the wall, of 20.0 mm") &&
                   Catch::Contains("rig"));
    w.result.at_end.faces = {face(dem::FaceKind::beam_joint, 0.009, -1e6)};
    CHECK_THAT(remarks(w, on_joint), !Catch::Contains("rig"));
    w.result.at_end.faces = {face(dem::FaceKind::head_joint, 0.015, -1e6)};
    CHECK_THAT(remarks(w, on_joint), !Catch::Contains("rig"));
}

TEST_CASE("hand checks: a toe that no stone could be is remarked where joints do not crush",
          "[app][hand_checks]")
{
    app::PushedWall w = pushed(10e3);
    const Overrides joint = {"wall.base=joint"};
    w.result.at_end.faces = {face(dem::FaceKind::base_joint, 0.0, -37.1e6)};
    CHECK_THAT(remarks(w, joint), Catch::Contains("the toe carries 37.1 MPa") &&
                                      Catch::Contains("of the units (3.7 MPa)"));
    CHECK_THAT(remarks(w, {"wall.base=joint", "joint.compressive_strength=60 MPa"}),
               !Catch::Contains("the toe carries"));
    w.result.at_end.faces = {face(dem::FaceKind::base_joint, 0.0, -36.9e6)};
    CHECK_THAT(remarks(w, joint), !Catch::Contains("the toe carries"));
}

TEST_CASE("hand checks: a wall that is not symmetric has both peaks, or how to find the other",
          "[app][hand_checks]")
{
    const Overrides door = {"wall.openings=0.2 m, 0 m, 0.2 m, 0.5 m"};
    app::PushedWall w = pushed(100e3);
    CHECK_THAT(remarks(w), !Catch::Contains("symmetric"));
    CHECK_THAT(remarks(w, door), Catch::Contains("pushed to the right alone") &&
                                     Catch::Contains("load.direction=both"));
    w.other_way.push_back(w);
    w.other_way.front().reading.peak->force = 61e3;
    CHECK_THAT(remarks(w, door),
               Catch::Contains("to the right it carries 100.0 kN, to the left "
                               "61.0 kN (39 % less)"));
    CHECK_THAT(remarks(w, {door[0], "load.targets=5, -5 mm"}), !Catch::Contains("symmetric"));
    w.reading.backbones.assign(4, w.reading);
    w.reading.backbones[3].peak->force = 61e3;
    CHECK_THAT(
        remarks(w, {door[0], "load.targets=5, -5 mm"}),
        Catch::Contains("to the right it carries 100.0 kN, to the left 61.0 kN (39 % less); "
                        "fragility.backbone"));
    CHECK_THAT(remarks(w, {"load.targets=5, -5 mm"}), !Catch::Contains("symmetric"));
    const app::Study left = study_texts::read_good({door[0], "load.targets=-20 mm"});
    CHECK(app::push_plan(app::turned_round(left)).targets == std::vector{0.02});
}

TEST_CASE(
    "hand checks: a wall that stood and was lost at once is said to be that, with what to try",
    "[app][hand_checks]")
{
    app::PushedWall w = pushed(10e3);
    CHECK_THAT(remarks(w), !Catch::Contains("was lost as soon"));
    w.result.outcome = dem::Outcome::lost_equilibrium;
    w.displacement = w.force = {0.0};
    CHECK_THAT(remarks(w),
               Catch::Contains("was lost as soon") && Catch::Contains("solver.accuracy"));
    w.result.settled = false; // it came down under its vertical load
    CHECK_THAT(remarks(w), !Catch::Contains("was lost as soon"));
}

TEST_CASE("hand checks: a wall that stood only in a slow start is said to be near its limit",
          "[app][hand_checks]")
{
    app::PushedWall w = pushed(10e3);
    CHECK_THAT(remarks(w), !Catch::Contains("put on as always"));
    w.result.slow_starts = 1;
    CHECK_THAT(remarks(w), Catch::Contains("put on as always"));
    w.result.settled = false; // it may be coming down
    CHECK_THAT(remarks(w), !Catch::Contains("put on as always"));
}

TEST_CASE(
    "hand checks: a wall that rocks on few contact points is said to be uncertain, by what "
    "it was at its peak or at the drop, and not by how it came down",
    "[app][hand_checks]")
{
    app::PushedWall w = pushed(10e3);
    CHECK_THAT(remarks(w), !Catch::Contains("contact points"));
    dem::FaceState rocks; // two points, the whole thrust of 1 MN at one end
    rocks.normal = rocks.acting = {0.0, 1.0};
    rocks.contacts.resize(2);
    rocks.contacts[0] = {{0.0, 0.0}, 0.1, -1e-4, 0.0, -1e7};
    rocks.contacts[1] = {{1.0, 0.0}, 0.1, 9.9e-3};
    dem::Snapshot tilted;
    tilted.displacement = 0.01;
    tilted.force = 10e3;
    tilted.faces = {rocks};
    dem::Snapshot upright = tilted;
    upright.faces[0].contacts[1] = rocks.contacts[0];
    upright.faces[0].contacts[1].at.x = 1.0;

    dem::PushResult r;
    r.faces_at_peak = r.at_end = upright;
    CHECK(app::points_error(r) == 0.0);
    r.at_end = tilted;
    // N (c/3) theta/u over the force: springs along the face close over c = 0.1 m.
    const Approx most = Approx(1e6 * (0.1 / 3) / 10e3).epsilon(1e-9);
    CHECK(app::points_error(r) == most);
    r.at_drop = upright;
    CHECK(app::points_error(r) == 0.0);
    r.at_drop.reset();
    r.outcome = dem::Outcome::lost_equilibrium;
    CHECK(app::points_error(r) == 0.0);
    r.faces_at_peak = tilted;
    CHECK(app::points_error(r) == most);

    w.result.faces_at_peak = tilted;
    CHECK_THAT(remarks(w), Catch::Contains("contact points"));
}

TEST_CASE("hand checks: a push by body forces has its load factor, one by the beam has none",
          "[app][hand_checks]")
{
    app::PushedWall wall = pushed(2e3);
    wall.result.weight = 16e3;
    CHECK(remarks(wall).find("load factor") == std::string::npos);
    wall.loads.pattern = dem::LoadPattern::body;
    CHECK(remarks(wall).find("the peak force is 0.125 times the weight that is pushed (load "
                             "factor); displacements are means over the wall by weight") !=
          std::string::npos);
    wall.reading.peak.reset();
    CHECK(remarks(wall).find("load factor") == std::string::npos);
}

TEST_CASE(
    "hand checks: a wall that yields before the first point of a side is said to be stiffer",
    "[app][hand_checks]")
{
    app::PushedWall wall = pushed(1e3);
    wall.reading.stiffness = 1e5;
    CHECK_THAT(remarks(wall), !Catch::Contains("stiffer"));
    wall.force = {0.0, 890.0, 1e3};
    CHECK_THAT(remarks(wall),
               Catch::Contains("is at 89 % of the peak by the first point of the "
                               "curve, at 10.00 mm: the wall is stiffer"));
    wall.reading.stiffness.reset(); // nothing is read
    CHECK_THAT(remarks(wall), !Catch::Contains("stiffer"));
    // to and fro: the second side, but no later cycle
    wall.reading.stiffness = 1e5;
    wall.displacement = {0.0, 0.01, 0.02, -0.01, -0.02, 0.01};
    wall.force = {0.0, 500.0, 1e3, -600.0, -1e3, 900.0};
    CHECK_THAT(remarks(wall), !Catch::Contains("stiffer"));
    wall.force[3] = -800.0;
    CHECK_THAT(remarks(wall), Catch::Contains("at 80 % of the peak"));
}
