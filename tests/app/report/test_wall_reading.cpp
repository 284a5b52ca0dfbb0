#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/reading/wall_reading.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/study/stored/study_walls.hpp"
#include "scenes/temporary_folder.hpp"
#include "tests/app/report/fragility_keys.hpp"
#include "tests/app/report/report_scene.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace {

/// Rises to 50 kN at 10 mm, falls to 30 kN at 20 mm.
const std::vector<double> kAt = {0.0, 0.005, 0.010, 0.020};
const std::vector<double> kForce = {0.0, 40e3, 50e3, 30e3};

/// Reading rules of a small study with some keys changed.
app::ReadingRules rules(const std::vector<std::string>& overrides = {})
{
    return app::reading_rules(
        app::prepare(app::read_study(app::with_overrides(
                         app::parse_study_text("study.ini", study_scenes::kSmall), overrides)))
            .study);
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
    CHECK(app::same_limit(a.ultimate_range.earliest, b.ultimate_range.earliest));
    CHECK(app::same_limit(a.ultimate_range.latest, b.ultimate_range.latest));
    CHECK(a.mode == b.mode);
    CHECK(a.dropped == b.dropped);
    CHECK(a.slid == b.slid);
    CHECK(a.mode_so_far == b.mode_so_far);
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
    const dem::Model model = app::model_of(app::prepare(study));
    const app::SamplePlan plan =
        sample_plan(study, study.load, study.source, model.layout, walls.head.design_sizes);
    for (const app::StudyLevel& level : walls.levels)
        for (const app::StudyWall& w : level.walls) {
            const int at = static_cast<int>(w.key.level);
            const app::PushedWall fresh = scenes::push_one(
                study, app::draw(plan, at, static_cast<int>(w.key.sample)), at);
            check_equal(fresh.reading, w.reading);
            CHECK(is_defined(w.reading.ultimate_range.latest));
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
    CHECK(is_censored(never.ultimate));
    CHECK(never.mode == dem::FailureMode::rocking);
    CHECK(never.mode_so_far);
    CHECK_FALSE(w.mode_so_far);
    CHECK_FALSE(app::read({kAt, kForce}, {0.9, 0.1, 0, 0},
                          rules({"fragility.ultimate_share=0.5", "fragility.modes=two"}))
                    .mode_so_far); // as the paper has it, what stands rocks
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
    CHECK_FALSE(app::read({kAt, kForce}, {0.9, 0.1, 0, 0}, rules()).mode_so_far);
}

TEST_CASE("wall reading: the error of the forces is an error of the ultimate displacement",
          "[app][wall_reading]")
{
    const auto read = [](double error, const app::ReadingRules& by) {
        return app::read({kAt, kForce}, {0.9, 0.1, 0, 0}, by, false, error);
    };
    const app::WallReading w = read(0.05, rules()); // 2 kN, which is 1 mm of 15
    CHECK(w.ultimate_range.earliest.displacement == Approx(0.014));
    CHECK(w.ultimate_range.latest.displacement == Approx(0.016));
    CHECK(app::ultimate_error(w) == Approx(1.0 / 15.0));
    CHECK(app::ultimate_error(read(0.0, rules())) == Approx(0.02)); // twice the accuracy
    CHECK(std::isnan(app::ultimate_error(app::read({kAt, kForce}, {0.9, 0.1, 0, 0}, rules()))));
    const app::ReadingRules never = rules({"fragility.ultimate_share=0.5"});
    CHECK(std::isnan(app::ultimate_error(read(0.05, never))));
    const app::WallReading open = read(0.5, rules());
    CHECK(app::ends_in_range(open));
    CHECK(app::ultimate_error(open) ==
          Approx((kAt.back() - open.ultimate.displacement) / open.ultimate.displacement));
    CHECK(app::worse_of(read(0.01, rules()), w).ultimate_range.earliest.displacement ==
          Approx(0.014));
}

TEST_CASE(
    "wall reading: a wall that came down has collapsed where its curve ends, one whose force "
    "came to zero where it did, and another is censored",
    "[app][wall_reading]")
{
    const app::ReadingRules all = rules({"fragility.limit_states=paper, collapse"});
    REQUIRE(state_names(all).back().set == "collapse");
    const app::WallReading stands = app::read({kAt, kForce}, {}, all);
    CHECK(is_censored(stands.collapse));
    CHECK(is_censored(stands.limits.back()));
    const app::WallReading fell = app::read({kAt, kForce, true}, {}, all);
    CHECK(is_observed(fell.limits.back()));
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

TEST_CASE("wall reading: a push that turns back is read on its backbones, by direction",
          "[app][wall_reading]")
{
    // right: 50 kN at 2 mm, 45 when it is there again, 38 at 4 (below 80 %); left: 40 kN at 2,
    // 36 at 4, where it ends
    const std::vector<double> at = {0,     0.001, 0.002, 0,      -0.001, -0.002, 0,
                                    0.002, 0.004, 0,     -0.002, -0.004, 0},
                              force = {0,    40e3, 50e3, -9e3,  -35e3, -40e3, 9e3,
                                       45e3, 38e3, -9e3, -38e3, -36e3, 9e3};
    const auto reading = [&](const std::string& side) {
        return app::read({at, force}, {0.9, 0.1, 0, 0},
                         rules({"load.amplitudes=2, 4 mm", "fragility.backbone=" + side}));
    };
    const app::WallReading mean = reading("mean"), worse = reading("worse"),
                           right = reading("right"), left = reading("left");
    CHECK(mean.no_reading.empty());
    CHECK(mean.peak->force == Approx(45e3));
    CHECK(right.peak->force == 50e3);
    CHECK(right.dropped);
    CHECK(right.ultimate.displacement == Approx(0.002 + 0.002 * 5.0 / 7.0));
    CHECK(left.peak->force == 40e3);
    CHECK(is_censored(left.ultimate));
    CHECK(left.ultimate.displacement == 0.004);
    CHECK(worse.peak->force == 40e3);
    CHECK(worse.ultimate.displacement == right.ultimate.displacement);
    CHECK(worse.dropped);
    REQUIRE(mean.backbones.size() == fragility::kSideNames.size());
    check_equal(mean.backbones[static_cast<std::size_t>(fragility::Side::right)], right);
    REQUIRE(mean.limits.size() == state_names(rules()).size());
    CHECK(app::capacity_curve({at, force}, rules({"load.amplitudes=2, 4 mm"})).force.back() ==
          Approx(37e3));
}

namespace {

/// A joint of 4 kN/mm that slides at 4 kN, beyond 1 mm: there, back, to the other side, back,
/// and so on.
app::WallReading sliding_joint(const std::vector<double>& amplitudes, const std::string& side)
{
    constexpr double kN = 1e3, mm = 1e-3;
    std::vector<double> at = {0.0}, force = {0.0};
    for (const double a : amplitudes)
        for (const double to : {a, -a, 0.0}) {
            const double step = to > at.back() / mm ? 0.05 : -0.05;
            while (std::abs(to - at.back() / mm) > 0.01) {
                at.push_back(at.back() + step * mm);
                force.push_back(std::clamp(force.back() + 4 * kN * step, -4 * kN, 4 * kN));
            }
            at.back() = to * mm;
        }
    return app::read({at, force}, {0.0, 1.0, 0, 0},
                     rules({"load.amplitudes=1 mm", "fragility.limit_states=ec8, ntc",
                            "fragility.backbone=" + side}));
}

} // namespace

TEST_CASE("wall reading: a first amplitude within yield leaves the yield as it is",
          "[app][wall_reading]")
{
    for (const char* const side : {"mean", "left", "right"}) {
        const app::WallReading w = sliding_joint({0.5, 3.0, 6.0}, side);
        INFO(side);
        // DL: on the left the backbone steps up to the force of the second cycle at 0.5 mm
        CHECK(w.limits[0].displacement == Approx(1e-3).epsilon(0.1));
        CHECK(*w.stiffness == Approx(4e6).epsilon(0.02));
        CHECK(w.begin_with == 0.0);
    }
    // little beyond: what it leaves is taken into account
    const app::WallReading w = sliding_joint({1.05, 3.0, 6.0}, "left");
    CHECK(w.limits[0].displacement == Approx(1e-3).epsilon(0.02));
    CHECK(*w.stiffness == Approx(4e6).epsilon(0.02));
}

TEST_CASE("wall reading: a first amplitude beyond yield has no yield, and says what to do",
          "[app][wall_reading]")
{
    for (const char* const side : {"mean", "left", "worse"}) {
        const app::WallReading w = sliding_joint({3.0, 6.0}, side);
        INFO(side);
        CHECK_FALSE(w.stiffness);
        CHECK_FALSE(is_defined(w.limits[0])); // DL
        CHECK(w.limits[0].reason == "the first amplitude lies beyond yield");
        CHECK(is_defined(w.limits[2]));                      // NC
        CHECK_FALSE(is_defined(w.limits[3]));                // SLO
        CHECK_FALSE(is_defined(w.limits[4]));                // SLD
        CHECK(is_defined(w.limits[6]));                      // SLC
        CHECK(w.begin_with == Approx(0.5e-3).epsilon(0.03)); // half of the yield
    }
    const app::WallReading right = sliding_joint({3.0, 6.0}, "right"); // loaded first
    CHECK(right.limits[0].displacement == Approx(1e-3).epsilon(0.02));
    CHECK(right.begin_with == 0.0);
    const std::string said = app::no_yield_remark(sliding_joint({3.0, 6.0}, "mean"));
    CHECK(said.find("begin the cycles with 0.5 mm or less") != std::string::npos);
    CHECK(app::no_yield_remark(right).empty());
}

TEST_CASE("wall reading: a push that turns back on one side is read on that side",
          "[app][wall_reading]")
{
    std::vector<double> at = kAt, force = kForce;
    at.insert(at.end(), {0.5 * kAt.back(), kAt.back()});
    force.insert(force.end(), {0.0, kForce.back()});
    const app::ReadingRules there = rules({"load.targets=20, 10, 20 mm"});
    REQUIRE(there.direction == 0);
    const app::WallReading w = app::read({at, force}, {0.9, 0.1, 0, 0}, there);
    const app::WallReading once = app::read({kAt, kForce}, {0.9, 0.1, 0, 0}, rules());
    check_equal(w, once);
    const app::WallReading left =
        app::read({at, force}, {0.9, 0.1, 0, 0},
                  rules({"load.targets=20, 10, 20 mm", "fragility.backbone=left"}));
    CHECK(left.no_reading.find("never goes to this side") != std::string::npos);
    CHECK_FALSE(is_defined(left.limits.front()));
}

TEST_CASE("wall reading: a wall that came down under its vertical load is not read",
          "[app][wall_reading]")
{
    const std::vector<double> one = {0.0};
    const app::WallReading w = app::read({one, one}, {}, rules());
    CHECK(w.no_reading == "the wall came down under vertical load");
    REQUIRE_FALSE(w.limits.empty());
    for (const fragility::LimitDisplacement& limit : w.limits)
        CHECK(limit.reason == w.no_reading);
}

TEST_CASE(
    "wall reading: a wall that stood under its vertical load is not said to have come down "
    "under it",
    "[app][wall_reading]")
{
    constexpr bool settled = true;
    const std::vector<double> one = {0.0};
    const app::WallReading w = app::read({one, one}, {}, rules(), settled);
    CHECK(w.no_reading ==
          "the wall stood under its vertical load and was lost as soon as it was pushed");
    REQUIRE_FALSE(w.limits.empty());
    for (const fragility::LimitDisplacement& limit : w.limits)
        CHECK(limit.reason == w.no_reading);
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

TEST_CASE(
    "wall reading: a fresh wall and a stored one that goes to and fro give the same numbers",
    "[app][wall_reading]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    scenes::run_study(file, "samples = 1\n[load]\namplitudes = 1, 2 mm");
    check_stored(file, {});
    for (const std::string_view side : fragility::kSideNames)
        check_stored(file, {"fragility.backbone=" + std::string(side)});
}

TEST_CASE("wall reading: curves of single precision are read as they are kept",
          "[app][wall_reading]")
{
    const scenes::TemporaryFolder folder;
    const auto file = folder.path / "study.h5";
    scenes::run_study(file, "samples = 2\n[output]\ncurves = single");
    check_stored(file, {});
}
