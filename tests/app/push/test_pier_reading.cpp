/// Piers read off pushes: each as a wall of its own, and the wall by the pier that governs.

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/prepared_study.hpp"
#include "app/push/limit_table.hpp"
#include "app/push/pier_picture.hpp"
#include "app/push/pier_table.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/pushed/wall_openings.hpp"
#include "dem/block/model.hpp"
#include "tests/app/push_scenes.hpp"
#include "tests/app/study_texts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace {

using Overrides = std::vector<std::string>;

/// A pier of 0.6 x 0.5 m under a course that is wider by 0.1 m on both sides.
const Overrides kUnderCourse = {
    "wall.length=0.8 m",
    "wall.courses=6",
    "stone.density=0 kg/m3",
    "beam.density=0 kg/m3",
    "wall.openings=0 m, 0 m, 0.1 m, 0.5 m; 0.7 m, 0 m, 0.1 m, 0.5 m",
    "lintel.bearing=0 m",
    "load.vertical_stress=0.375 MPa",
    "load.max_displacement=12 mm",
    "wall.toe=free",
    "fragility.limit_states=paper, ntc, ec8",
    "solver.accuracy=1 %",
    "solver.fidelity=simple"};

/// The same pier alone, under a course that is as long as it.
const Overrides kAlone = {"wall.length=0.6 m",
                          "wall.courses=6",
                          "stone.density=0 kg/m3",
                          "beam.density=0 kg/m3",
                          "load.vertical_stress=0.5 MPa",
                          "load.max_displacement=12 mm",
                          "wall.toe=free",
                          "fragility.limit_states=paper, ntc, ec8",
                          "solver.accuracy=1 %",
                          "solver.fidelity=simple"};

app::Study with(Overrides overrides, const Overrides& more = {})
{
    overrides.insert(overrides.end(), more.begin(), more.end());
    return study_texts::read(study_texts::kSmallWall, overrides);
}

/// @param shots takes a snapshot at every point of the curve
app::PushedWall pushed(const app::Study& study, std::vector<dem::Snapshot>* shots = nullptr)
{
    dem::PushPlan plan = app::push_plan(study);
    plan.snapshot_every = shots == nullptr ? 0.0 : plan.record_every;
    app::PushedWall wall = scenes::pushed(study, plan);
    if (shots != nullptr) *shots = wall.result.snapshots;
    return wall;
}

/// Movement of the underside of the course that begins at this height [m].
double movement_at(const dem::Snapshot& shot, double height)
{
    double sum = 0.0;
    int n = 0;
    for (const dem::BlockState& block : shot.blocks) {
        const auto low = std::ranges::min_element(block.outline, {}, &dem::Point::z);
        if (std::abs(low->z - height) > 1e-6) continue;
        for (std::size_t p = 0; p < block.outline.size(); ++p)
            if (std::abs(block.outline[p].z - height) < 1e-6) {
                sum += block.displacement[p].x;
                ++n;
            }
    }
    REQUIRE(n > 0);
    return sum / n;
}

/// A wall alone, read by the movement at a height below its load line.
app::WallReading read_at_height(const app::Study& study, double height)
{
    std::vector<dem::Snapshot> shots;
    const app::PushedWall wall = pushed(study, &shots);
    std::vector<double> displacement, force;
    std::size_t s = 0;
    for (std::size_t i = 0; i < wall.displacement.size(); ++i) {
        while (s + 2 < shots.size() && shots[s + 1].displacement < wall.displacement[i]) ++s;
        const double from = shots[s].displacement, to = shots[s + 1].displacement,
                     share = (wall.displacement[i] - from) / (to - from);
        displacement.push_back((1.0 - share) * movement_at(shots[s], height) +
                               share * movement_at(shots[s + 1], height));
        force.push_back(wall.force[i]);
    }
    app::ReadingRules rules = app::reading_rules(study);
    rules.height = height;
    rules.direction = 0; // as piers are: movements may come back
    rules.backbone = fragility::Side::right;
    return app::read({displacement, force}, wall.mechanism, rules, true);
}

double limit(const app::Study& study, const app::WallReading& r, const std::string& name)
{
    const auto names = app::state_names(app::reading_rules(study));
    for (std::size_t i = 0; i < names.size(); ++i)
        if (state_name(names[i]) == name) return r.limits.at(i).displacement;
    throw std::invalid_argument(name);
}

} // namespace

TEST_CASE("pier reading: a pier has the limits of a wall of its own", "[app][pier_reading]")
{
    const Overrides how = {
        GENERATE("joint.friction_angle=31.8 deg", "joint.friction_angle=15 deg")};
    const app::Study under = with(kUnderCourse, how), alone = with(kAlone, how);
    const app::PushedWall wall = pushed(under);
    constexpr double kHeight = 0.5; // of the pier [m]
    const app::WallReading own = read_at_height(alone, kHeight);
    REQUIRE(wall.piers.size() == 1);
    const app::PierReading& pier = wall.piers.front();
    CHECK(pier.facts.normal_at_peak == Approx(0.375e6 * 0.8 * 0.2).epsilon(0.005));
    CHECK(pier.facts.most_shear == Approx(peak_force(own)).epsilon(0.05));
    CHECK(pier.mode == own.mode);
    int known = 0;
    const auto names = app::state_names(app::reading_rules(under));
    for (std::size_t i = 0; i < names.size(); ++i) {
        INFO(state_name(names[i]));
        const auto &a = pier.own.limits.at(i), &b = own.limits.at(i);
        CHECK(is_observed(a) == is_observed(b));
        if (!is_observed(a)) continue; // where the push ends says nothing
        CHECK(a.displacement == Approx(b.displacement).epsilon(0.05));
        ++known;
    }
    CHECK(known >= 7); // of 8
}

TEST_CASE("pier reading: the wall's limit is where the first pier reaches its own drift",
          "[app][pier_reading]")
{
    // A short pier between a door and a window, and long ones beside them.
    const app::Study study =
        with({"wall.length=1.2 m", "wall.courses=6", "load.max_displacement=12 mm",
              "wall.openings=0.2 m, 0 m, 0.2 m, 0.5 m; 0.8 m, 0.3 m, 0.2 m, 0.2 m",
              "fragility.limit_states=ntc", "load.vertical_stress=0.3 MPa"});
    const app::PushedWall wall = pushed(study);
    REQUIRE(wall.piers.size() == 3);
    const int first = app::governing_pier(wall.piers, "ntc");
    REQUIRE(first > 0);
    const app::PierReading& pier = wall.piers[static_cast<std::size_t>(first) - 1];
    for (const app::PierReading& p : wall.piers)
        if (is_observed(p.caps.front().wall))
            CHECK(p.caps.front().wall.displacement >= pier.caps.front().wall.displacement);
    CHECK(limit(study, wall.reading, "ntc SLC") ==
          Approx(pier.caps.front().wall.displacement).epsilon(1e-9));
    // By the height of the whole wall it would be 1 or 0.5 % of 0.7 m.
    CHECK(pier.caps.front().wall.displacement < 0.005 * study.load.height * 1.4);
    const app::ReadingRules rules = app::reading_rules(study);
    CHECK(app::limit_table(rules, {wall}).rows.size() == 4);
    CHECK(app::pier_table(rules, {wall}).rows.size() == 3);
    CHECK(app::pier_limit_table(rules, {wall}).rows.size() == 12);
    CHECK(app::spandrel_table(rules, {wall}).rows.size() == 2);
    REQUIRE(app::piers_remarks(rules, wall).size() == 1);
    CHECK(app::piers_remarks(rules, wall).front().find("pier " + std::to_string(first)) !=
          std::string::npos);
    const std::string picture =
        app::pier_picture(study, study.load, app::layout_of(study, study.source), wall);
    for (const char* const text : {"pier 1", "pier 3", " kN"})
        CHECK(picture.find(text) != std::string::npos);
}

TEST_CASE("pier reading: snapshots that a push was to keep are kept beside those of piers",
          "[app][pier_reading]")
{
    Overrides short_push = kUnderCourse;
    std::erase(short_push, "load.max_displacement=12 mm");
    const app::Study study = with(short_push); // to 1 mm
    const auto taken = [&](const app::Study& pushed) {
        std::vector<double> at;
        dem::PushPlan plan = app::push_plan(study);
        plan.snapshot_every = 2e-4;
        plan.sink = {
            .take = [&](std::size_t, dem::Snapshot&& s) { at.push_back(s.displacement); },
            .forget = [&](std::size_t) { at.clear(); }};
        app::PushList list;
        list.size = 1;
        list.wall = [](std::size_t) { return app::WantedWall{}; };
        list.done = [](std::size_t, const app::WallDraw&, app::PushedWall&&) {};
        app::push_walls(pushed, app::model_of(app::prepare(study)), plan, list, 1);
        return at;
    };
    app::Study unwatched = study; // the same wall, whose openings nobody knows
    unwatched.geometry.openings.clear();
    const std::vector<double> plain = taken(unwatched);
    CHECK(plain.size() == 6);
    CHECK(taken(study) == plain);
}

TEST_CASE("pier reading: openings of a drawing are found where its stones leave them",
          "[app][pier_reading]")
{
    // A portal: two piers of three stones, a lintel.
    std::string outlines;
    for (const double x : {0.0, 0.8})
        for (const double z : {0.0, 0.2, 0.4}) {
            const auto n = [](double v) { return std::to_string(v); };
            outlines += n(x) + " " + n(z) + ", " + n(x + 0.2) + " " + n(z) + ", " + n(x + 0.2) +
                        " " + n(z + 0.2) + ", " + n(x) + " " + n(z + 0.2) + "; ";
        }
    outlines += "0 0.6, 1 0.6, 1 0.8, 0 0.8";
    const app::Study study =
        study_texts::read(study_texts::kSmallWall,
                          {"wall.outlines=" + outlines, "wall.length=", "wall.courses=",
                           "wall.course_height=", "wall.unit_length=", "wall.unit_cracks="});
    const auto openings = app::wall_openings(study);
    REQUIRE(openings.size() == 1);
    CHECK(openings[0].x == Approx(0.2).margin(0.005));
    CHECK(openings[0].width == Approx(0.6).margin(0.005));
    CHECK(openings[0].z == Approx(0.0).margin(0.005));
    CHECK(openings[0].height == Approx(0.6).margin(0.005));
    CHECK(app::tells_piers(study, study.load));
}

TEST_CASE("pier reading: a window of half a metre is an opening of a long drawn facade, too",
          "[app][pier_reading]")
{
    const auto openings = [](double window) {
        const std::string to = std::to_string(6.0 + window);
        const app::Study study = study_texts::read(
            study_texts::kSmallWall,
            {"wall.outlines=0 0, 12 0, 12 0.5, 0 0.5; 0 0.5, 6 0.5, 6 2, 0 2; " + to +
                 " 0.5, 12 0.5, 12 2, " + to + " 2; 0 2, 12 2, 12 2.5, 0 2.5",
             "wall.length=", "wall.courses=", "wall.course_height=", "wall.unit_length=",
             "wall.unit_cracks="});
        return app::wall_openings(study);
    };
    REQUIRE(openings(0.5).size() == 1);
    CHECK(openings(0.5).front().width == Approx(0.5));
    CHECK(openings(0.29).empty()); // a gap
}

TEST_CASE(
    "pier reading: a door of a drawing begins at the ground, a sill just above it does not",
    "[app][pier_reading]")
{
    // two posts of 2 m; of the 200 levels that are looked at the first is at 0.005 m
    const auto openings = [](const std::string& base, const std::string& z) {
        const app::Study study =
            study_texts::read(study_texts::kSmallWall,
                              {"wall.outlines=" + base + "0 " + z + ", 0.4 " + z +
                                   ", 0.4 2, 0 2; 0.8 " + z + ", 1.2 " + z + ", 1.2 2, 0.8 2",
                               "wall.length=", "wall.courses=", "wall.course_height=",
                               "wall.unit_length=", "wall.unit_cracks="});
        return app::wall_openings(study);
    };
    const auto door = openings("", "0");
    REQUIRE(door.size() == 1);
    CHECK(door.front().z == 0.0);
    CHECK(door.front().height == 2.0); // up to the beam
    const auto window = openings("0 0, 1.2 0, 1.2 0.002, 0 0.002; ", "0.002");
    REQUIRE(window.size() == 1);
    CHECK(window.front().z == Approx(0.002).margin(1e-9));
}

TEST_CASE("pier reading: openings of a drawing end where the stones do, at any height",
          "[app][pier_reading]")
{
    std::string outlines;
    const auto stone = [&](double x0, double z0, double x1, double z1) {
        const auto n = [](double v) { return std::to_string(v); };
        outlines += (outlines.empty() ? "" : "; ") + n(x0) + " " + n(z0) + ", " + n(x1) + " " +
                    n(z0) + ", " + n(x1) + " " + n(z1) + ", " + n(x0) + " " + n(z1);
    };
    // two windows with a post between them, below a wide one that joins both
    stone(0.0, 0.0, 1.7, 0.1307);
    stone(0.0, 0.1307, 0.4, 0.4111);
    stone(0.7, 0.1307, 0.9, 0.4111);
    stone(1.2, 0.1307, 1.7, 0.4111);
    stone(0.0, 0.4111, 0.4, 0.8013);
    stone(1.2, 0.4111, 1.7, 0.8013);
    stone(0.0, 0.8013, 1.7, 1.0);
    const app::Study study =
        study_texts::read(study_texts::kSmallWall,
                          {"wall.outlines=" + outlines, "wall.length=", "wall.courses=",
                           "wall.course_height=", "wall.unit_length=", "wall.unit_cracks="});
    auto openings = app::wall_openings(study);
    std::ranges::sort(openings, {}, &dem::Opening::height);
    REQUIRE(openings.size() == 2);
    CHECK(openings[0].z == Approx(0.1307).margin(1e-9));
    CHECK(openings[0].height == Approx(0.4111 - 0.1307).margin(1e-9));
    CHECK(openings[1].z == Approx(0.1307).margin(1e-9));
    CHECK(openings[1].height == Approx(0.8013 - 0.1307).margin(1e-9));
}

TEST_CASE(
    "pier reading: the mode is that where the pier's own shear came down, not that of the end",
    "[app][pier_reading]")
{
    const auto history_of = [](const std::vector<double>& shears, double way) {
        app::PierHistory history;
        for (const double shear : shears) {
            app::PierInstant now;
            now.piers.push_back({{.shear = way * shear}, 0.0});
            app::PierMovement m{true, {}};
            m.mechanism.rotation_share = 1.0 - 0.1 * static_cast<double>(history.size());
            now.movements.push_back(m);
            history.push_back(now);
        }
        return history;
    };
    const std::vector<double> shears = {1.0, 8.0, 10.0, 8.5, 7.9, 3.0, 9.0, 1.0};
    for (const double way : {1.0, -1.0}) {
        app::PierHistory history = history_of(shears, way);
        const auto own = app::movement_at_drop(history, 0, way, 0.8);
        REQUIRE(own);
        CHECK(own->mechanism.rotation_share == Approx(0.6)); // at 7.9
        history[4].movements.clear(); // between two looks the next one tells
        CHECK(app::movement_at_drop(history, 0, way, 0.8)->mechanism.rotation_share ==
              Approx(0.5));
        history[5].movements[0].moved = false;
        CHECK_FALSE(app::movement_at_drop(history, 0, way, 0.8));
        CHECK_FALSE(app::movement_at_drop(history, 0, way, 0.0)); // nobody asks for a drop
        CHECK_FALSE(app::movement_at_drop(history_of({1.0, 5.0, 4.5}, way), 0, way, 0.8));
        CHECK_FALSE(app::movement_at_drop(history_of({-1.0, -5.0}, way), 0, way, 0.8));
    }
}

TEST_CASE("pier reading: a pier that keeps its shear has a mode so far and no drop",
          "[app][pier_reading]")
{
    app::PierFacts keeps;
    keeps.movement = {0.0, 1e-3, 2e-3};
    keeps.shear = {0.0, 10e3, 8.5e3};
    keeps.most_shear = 10e3;
    keeps.slenderness = 1.0;
    keeps.moved = 1.0;
    keeps.mechanism.rotation_share = 1.0;
    app::PierFacts falls = keeps, still = keeps, idle = keeps;
    falls.shear.back() = 7.5e3;
    still.moved = 0.0;
    idle.most_shear = 100.0;
    const dem::Pier pier{{0.0, 0.0, 0.5, 0.5}, 0.25, 1};
    const std::vector<double> x{0.0, 1e-3, 2e-3}, f{0.0, 40e3, 39e3};
    const app::Study alone = with(kAlone);
    const auto read =
        app::read_piers(app::pier_rules(alone.fragility, app::reading_rules(alone)),
                        std::vector(4, pier), std::vector{keeps, falls, still, idle}, {x, f});
    CHECK(mode_text(read[0]) == "rocking so far");
    CHECK(app::is_so_far(mode_text(read[0])));
    CHECK(is_censored(read[0].own.ultimate));
    CHECK(read[0].own.ultimate.displacement == 2e-3);
    CHECK(mode_text(read[1]) == "rocking");
    CHECK(is_observed(read[1].own.ultimate));
    CHECK(mode_text(read[2]) == "stands still");
    CHECK(mode_text(read[3]) == "carries little");
}
