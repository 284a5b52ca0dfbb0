/// Where small displacements leave no drift limit, every output of a study says so.

#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/report/report_parts.hpp"
#include "app/study/answers/limit_choices.hpp"
#include "app/study/stored/turned_walls.hpp"
#include "app/study/study_summary.hpp"
#include "app/study_scenes.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace {

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// The effect of a choice in a study; empty where it plays no part.
std::string effect(const std::string& key, const std::string& keys)
{
    const app::Study study = study_scenes::study("samples = 1\n" + keys);
    for (const app::LimitChoice& choice : app::limit_choices(study))
        if (choice.key == key) return std::string(choice.effect);
    return "";
}

} // namespace

TEST_CASE(
    "limit choices: summary, tables and page say how many walls small displacements leave "
    "without a limit",
    "[app][limit_choices]")
{
    app::StudyWalls walls = scenes::study_walls(13); // 7 of 13 reach no limit under each stress
    const std::size_t stood = std::ranges::count_if(
        walls.levels[0].walls, [](const auto& w) { return is_censored(w.reading.ultimate); });
    REQUIRE(stood > 0);
    const std::string remark = app::no_limit_remark(walls);
    CHECK(remark.starts_with(
        std::to_string(2 * stood) +
        " of 26 walls still carried more than 80 % of the peak at the end: "));
    CHECK(has(remark, "solver.kinematics = finite"));
    CHECK(has(app::summarise(walls).remarks, remark + "\n"));
    CHECK(has(app::summarise(walls).table.caption, remark));
    CHECK(has(app::performance_table(app::drift_data(walls)).caption, remark));
    CHECK(std::ranges::count_if(app::overview(walls).sure, [&](const std::string& s) {
              return s.starts_with(remark);
          }) == 1);

    walls.study.solver.kinematics =
        dem::Kinematics::finite; // pushed too short a way: no such remark
    CHECK(app::no_limit_remark(walls).empty());
    CHECK_FALSE(has(app::summarise(walls).remarks, "kinematics"));
}

TEST_CASE("limit choices: the page's assumptions begin with them, each with what it does",
          "[app][limit_choices]")
{
    const app::Table t = app::choice_table(scenes::study_walls(3));
    REQUIRE(t.rows.size() >= 4);
    CHECK(app::cell_text(t.rows.front()[0]) == "solver: kinematics");
    CHECK(app::cell_text(t.rows.front()[1]) == "small");
    CHECK(has(app::cell_text(t.rows.front()[3]), "has no limit"));
    CHECK(has(app::limit_choices_text(app::limit_choices(scenes::study_walls(3).study)),
              "limit: solver.kinematics = small, wall.base = fixed"));
}

TEST_CASE("limit choices: what plays no part in a study is left out", "[app][limit_choices]")
{
    const std::string joint = "[wall]\nbase = joint\n",
                      small = "[solver]\nkinematics = small\n";
    CHECK(effect("load.top", small).empty()); // it keeps its lever arm
    CHECK(has(effect("load.top", ""), "lever arm shrinks"));
    CHECK(has(effect("wall.toe", joint), "cannot slide away"));
    CHECK(has(effect("wall.toe", joint + "toe = free\n"), "only friction"));
    CHECK(has(effect("joint.compressive_strength", ""), "any stress"));
    CHECK(has(effect("joint.compressive_strength", "[joint]\ncompressive_strength = 40 MPa\n"),
              "joints crush"));
}

TEST_CASE("limit choices: a study of walls that are not symmetric says that they went one way",
          "[app][limit_choices]")
{
    app::StudyWalls walls = scenes::study_walls(3);
    CHECK(app::other_way_remark(walls).empty());
    const std::string door = "samples = 8\n[wall]\nopenings = 0.1 m, 0 m, 0.2 m, 0.2 m\n";
    walls.study = study_scenes::study(door);
    const std::string remark = app::other_way_remark(walls);
    CHECK(has(remark, "all walls were pushed to the right; to the left they may carry less"));
    CHECK(has(remark, "drystone push scene.h5 --sample mean --level STRESS"));
    CHECK(has(app::summarise(walls).remarks, remark + "\n"));
    CHECK(std::ranges::count_if(app::overview(walls).sure, [&](const std::string& s) {
              return s.starts_with(remark);
          }) == 1);

    walls.study = study_scenes::study(door + "[load]\ntargets = 2, -2 mm\n");
    CHECK(app::other_way_remark(walls).empty()); // it goes both ways
}
