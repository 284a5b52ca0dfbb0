#include "app/reading/wall_reading.hpp"

#include "app/fragility_keys.hpp"
#include "app/input/limit_state_text.hpp"
#include "app/report_scene.hpp"
#include "app/study/pushed_wall.hpp"
#include "app/study/study_walls.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

/// Rises to 50 kN at 10 mm, falls to 30 kN at 20 mm.
const std::vector<double> kAt = {0.0, 0.005, 0.010, 0.020};
const std::vector<double> kForce = {0.0, 40e3, 50e3, 30e3};

/// Of a small study with some keys changed.
app::ReadingRules rules(const std::vector<std::string>& overrides = {})
{
    return app::reading_rules(app::read_study(app::with_overrides(
        app::parse_study_text("study.ini", study_scenes::kSmall), overrides)));
}

std::vector<double> negative(std::vector<double> values)
{
    for (double& x : values) x = -x;
    return values;
}

void check_equal(const app::WallReading& a, const app::WallReading& b)
{
    CHECK(a.no_reading == b.no_reading);
    REQUIRE(a.peak.has_value() == b.peak.has_value());
    if (a.peak) CHECK(a.peak->force == b.peak->force);
    if (a.peak) CHECK(a.peak->displacement == b.peak->displacement);
    CHECK(a.stiffness == b.stiffness);
    CHECK(a.ultimate.displacement == b.ultimate.displacement);
    CHECK(a.ultimate.reading == b.ultimate.reading);
    CHECK(a.mode == b.mode);
    CHECK(a.dropped == b.dropped);
    CHECK(a.slid == b.slid);
    REQUIRE(a.limits.size() == b.limits.size());
    for (std::size_t i = 0; i < a.limits.size(); ++i) {
        CHECK(a.limits[i].displacement == b.limits[i].displacement);
        CHECK(a.limits[i].reading == b.limits[i].reading);
        CHECK(a.limits[i].reason == b.limits[i].reason);
    }
}

/// Walls of a stored study are pushed again and read by the same rules.
void check_stored(const std::filesystem::path& file, const std::vector<std::string>& overrides)
{
    const app::StudyWalls walls = app::read_study_walls(file, overrides, app::Keep::everything);
    const app::Study& study = walls.study;
    const dem::Model model = app::model_of(study);
    const app::SamplePlan plan = sample_plan(study, model.layout, walls.head.design_sizes);
    for (const app::StudyLevel& level : walls.levels)
        for (const app::StudyWall& w : level.walls) {
            const int at = static_cast<int>(w.key.level);
            const app::PushedWall fresh = scenes::push_one(
                study, app::draw(plan, at, static_cast<int>(w.key.sample)), at);
            check_equal(fresh.reading, w.reading);
        }
}

} // namespace

TEST_CASE("wall reading: peak, ultimate displacement and mode follow the rules of the study",
          "[app][wall_reading]")
{
    const app::WallReading w =
        app::read({kAt, kForce}, {0.9, 0.1, 0, 0}, rules({"fragility.modes=two"}));
    CHECK(w.peak->force == 50e3);
    CHECK(w.ultimate.displacement == Approx(0.015).epsilon(1e-14)); // 40 kN
    CHECK(w.mode == dem::FailureMode::mixed);
    const app::WallReading never =
        app::read({kAt, kForce}, {0.9, 0.1, 0, 0}, rules({"fragility.ultimate_share=0.5"}));
    CHECK(app::is_censored(never.ultimate));
    CHECK(never.mode == dem::FailureMode::rocking);
    const app::WallReading cracked =
        app::read({kAt, kForce}, {0.9, 0.1, 1, 4},
                  rules({"fragility.ultimate_share=0.5", "fragility.rotation_share=0.95"}));
    CHECK(cracked.mode == dem::FailureMode::mixed);
    const app::WallReading slid =
        app::read({kAt, kForce}, {0.1, 0.9, 0, 0},
                  rules({"fragility.ultimate_share=0.5", "fragility.modes=two"}));
    CHECK(slid.slid);
    CHECK(slid.mode == dem::FailureMode::rocking);
    const app::WallReading slides = app::read({kAt, kForce}, {0.1, 0.9, 0, 0}, rules());
    CHECK_FALSE(slides.slid);
    CHECK(slides.mode == dem::FailureMode::sliding);
    CHECK(app::read({kAt, kForce}, {0.9, 0.1, 0, 0}, rules()).mode ==
          dem::FailureMode::rocking);
}

TEST_CASE(
    "wall reading: a wall that came down has collapsed where its curve ends, one whose force "
    "came to zero where it did, and another is censored",
    "[app][wall_reading]")
{
    const app::ReadingRules all = rules({"fragility.limit_states=paper, collapse"});
    REQUIRE(state_names(all).back().set == "collapse");
    const app::WallReading stands = app::read({kAt, kForce}, {}, all);
    CHECK(app::is_censored(stands.collapse));
    CHECK(app::is_censored(stands.limits.back()));
    const app::WallReading fell = app::read({kAt, kForce, true}, {}, all);
    CHECK(app::is_observed(fell.limits.back()));
    CHECK(fell.limits.back().displacement == kAt.back());
    CHECK(fell.collapse.displacement == kAt.back());
    CHECK(fell.ultimate.displacement == stands.ultimate.displacement); // it had dropped before
    std::vector<double> at = kAt, force = kForce;
    at.push_back(2.0 * kAt.back());
    force.push_back(-kForce.back());
    const app::WallReading zero = app::read({at, force}, {}, all);
    CHECK(zero.limits.back().displacement == Approx(1.5 * kAt.back()).epsilon(1e-12));
    const app::ReadingRules left = rules({"load.targets=-4 mm"});
    CHECK(app::read({negative(at), negative(force)}, {}, left).collapse.displacement ==
          zero.collapse.displacement);
}

TEST_CASE("wall reading: a push to the left is read like one to the right",
          "[app][wall_reading]")
{
    const app::ReadingRules right = rules(), left = rules({"load.targets=-4 mm"});
    REQUIRE(left.direction == -1);
    check_equal(app::read({negative(kAt), negative(kForce)}, {0.9, 0.1, 2, 4}, left),
                app::read({kAt, kForce}, {0.9, 0.1, 2, 4}, right));
}

TEST_CASE("wall reading: nothing is read off a push that turns back, or a wall that came down",
          "[app][wall_reading]")
{
    const app::ReadingRules cyclic = rules({"load.targets=2, -2 mm"});
    REQUIRE(cyclic.direction == 0);
    const app::WallReading w = app::read({kAt, kForce}, {0.2, 0.1, 2, 4}, cyclic);
    CHECK(w.no_reading.find("turns back") != std::string::npos);
    CHECK_FALSE(w.peak);
    REQUIRE(w.limits.size() == state_names(cyclic).size());
    CHECK_FALSE(app::is_defined(w.limits.front()));
    CHECK(w.mode == dem::FailureMode::mixed); // cracked units and little rotation need no curve
    const std::vector<double> one = {0.0};
    CHECK(app::read({one, one}, {}, rules()).no_reading.find("came down") != std::string::npos);
}

TEST_CASE("wall reading: a fresh wall and a stored one give the same numbers for every key",
          "[slow][app][wall_reading]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    scenes::run_study(file, "samples = 2");
    check_stored(file, {});
    for (const std::vector<std::string>& overrides : scenes::changed_fragility_keys()) {
        CAPTURE(overrides.front());
        check_stored(file, overrides);
    }
}

TEST_CASE("wall reading: curves of single precision are read as they are kept",
          "[app][wall_reading]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    scenes::run_study(file, "samples = 2\n[output]\ncurves = single");
    check_stored(file, {});
}
