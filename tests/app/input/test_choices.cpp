#include "app/choices/choice_list.hpp"
#include "app/choices/choice_table.hpp"
#include "app/choices/choices_command.hpp"
#include "app/input/study/units.hpp"
#include "app/study_texts.hpp"
#include "app/text/config_error.hpp"
#include "scenes/temporary_folder.hpp"
#include "scenes/terminal.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::string kWall = study_texts::kSmallWall;

std::string file_in(const fs::path& folder, const std::string& text)
{
    std::ofstream(folder / "a.ini") << text;
    return (folder / "a.ini").string();
}

const app::ChoiceChange& change_of(const std::vector<app::ChoiceChange>& all,
                                   const std::string& key)
{
    const auto found = std::ranges::find(all, key, &app::ChoiceChange::key);
    REQUIRE(found != all.end());
    return *found;
}

app::ChoiceResult result(const std::string& after, double peak, double limit, bool censored)
{
    app::ChoiceResult r{"k", "a", after, "", app::WallReading{}, 1.0};
    r.reading->peak = fragility::Peak{.force = peak, .displacement = 0.001};
    r.reading->ultimate.displacement = limit;
    r.reading->ultimate.reading =
        censored ? fragility::Reading::censored : fragility::Reading::observed;
    return r;
}

} // namespace

TEST_CASE("choices: each change differs from the study in its own key alone", "[app][choices]")
{
    const scenes::TemporaryFolder folder;
    const std::string file = file_in(folder.path, kWall);
    const auto all = app::choice_changes(file, {});
    CHECK(all.size() >= 12);
    std::set<std::string> keys;
    std::size_t applied = 0;
    for (const app::ChoiceChange& c : all) {
        INFO(c.key << " = " << c.after << ": " << c.not_applied);
        keys.insert(c.key);
        CHECK(c.before != c.after);
        applied += c.not_applied.empty() ? 1 : 0;
    }
    CHECK(keys.size() == 13);
    CHECK(applied >= 9);
    CHECK(change_of(all, "solver.kinematics").ready.study.solver.kinematics ==
          dem::Kinematics::small);
    CHECK(change_of(all, "wall.base").ready.study.wall.base == dem::Base::fixed);
    CHECK(app::push_plan(change_of(all, "load.direction").ready.study).targets ==
          std::vector{-1e-3});
    CHECK(change_of(all, "joint.closure").ready.study.parameters.joint.closure ==
          dem::Closure::exponential);
}

TEST_CASE("choices: what does not apply says why", "[app][choices]")
{
    const scenes::TemporaryFolder folder;
    const std::string file = file_in(folder.path, kWall);
    const std::vector<std::string> small = {"solver.kinematics=small"};
    CHECK(change_of(app::choice_changes(file, small), "load.top")
              .not_applied.find("small displacements") != std::string::npos);
    const std::vector<std::string> mortar = {"joint.cohesion=0.1 MPa"};
    CHECK(change_of(app::choice_changes(file, mortar), "joint.closure")
              .not_applied.find("mortar") != std::string::npos);
    const std::vector<std::string> to_and_fro = {"load.amplitudes=1 mm"};
    CHECK(change_of(app::choice_changes(file, to_and_fro), "load.direction").not_applied ==
          "the push goes to and fro");
}

TEST_CASE("choices: joints that close keep their stiffness when they no longer do",
          "[app][choices]")
{
    const scenes::TemporaryFolder folder;
    const std::string file = file_in(folder.path, kWall);
    const std::vector<std::string> closes = {"joint.wall_modulus=", "joint.closure=exponential",
                                             "joint.initial_stiffness=4 GPa/m",
                                             "joint.maximum_closure=0.1 mm"};
    const auto all = app::choice_changes(file, closes);
    const app::ChoiceChange& c = change_of(all, "joint.closure");
    INFO(c.not_applied);
    // k_0 + sigma / V_m = 4 + 0.5e6 / 1e-4 / 1e9 GPa/m
    CHECK(c.ready.study.parameters.joint.normal_stiffness == std::vector{9e9});
}

TEST_CASE("choices: the largest change comes first, and a limit not reached is a bound",
          "[app][choices]")
{
    const app::ChoiceResult base = result("", 100e3, 0.010, false);
    const std::vector<app::ChoiceResult> all = {result("little", 101e3, 0.011, false),
                                                result("much", 60e3, 0.030, true),
                                                {"k", "a", "never", "does not apply", {}, 1.0}};
    const app::Tornado t = app::tornado(base, all);
    REQUIRE(t.peak.size() == 2);
    CHECK(t.peak.front().label == "k = much");
    CHECK(t.peak.front().change == Approx(-0.4));
    REQUIRE(t.limit.size() == 2);
    CHECK(t.limit.front().change == Approx(2.0));
    CHECK(t.limit.front().at_least);
    CHECK_FALSE(t.limit.back().at_least);
    CHECK(app::tornado(result("", 100e3, 0.010, true), all).limit.empty());
    const std::string csv = app::as_csv(app::choice_results(base, all));
    CHECK(csv.find("not applied: does not apply") != std::string::npos);
    CHECK(app::tornado_svg(t, "a < b").find("a &lt; b") != std::string::npos);
}

TEST_CASE("choices: the same bits on any number of threads", "[app][choices]")
{
    const scenes::TemporaryFolder folder;
    app::Command c;
    c.study = file_in(folder.path, kWall);
    c.quiet = true;
    const scenes::Terminal terminal;
    for (const int threads : {1, 3}) {
        c.threads = threads;
        c.out = (folder.path / std::to_string(threads)).string();
        CHECK(app::choices_command(c) == 0);
    }
    for (const char* const name : {"choices.csv", "choices.svg"})
        CHECK(scenes::read_text(folder.path / "1" / name) ==
              scenes::read_text(folder.path / "3" / name));
    c.study = "a.h5";
    CHECK_THROWS_AS(app::choices_command(c), app::ConfigError);
}
