#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"
#include "app/report/report_parts.hpp"
#include "app/surrogate/surrogate_output.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"
#include "uq/surrogates/polynomials.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

namespace {

/// The walls of the scene, with the distributions of its study.
app::StudyWalls asked_walls(std::size_t n)
{
    app::StudyWalls walls = scenes::study_walls(n);
    for (app::StoredInput& input : walls.inputs) {
        const app::Key& key = *app::find_key(input.key);
        input.scale = app::from_si(1.0, key.unit);
        for (const app::RandomInput& r : walls.study.random)
            if (r.key == input.key) input.marginal = r.marginal;
    }
    return walls;
}

} // namespace

TEST_CASE(
    "report what if: sliders reach over all walls, and their coordinates are those of the "
    "values shown",
    "[app][report_whatif]")
{
    app::StudyWalls walls = asked_walls(30);
    app::StudyWall failed = walls.levels.front().walls.front();
    failed.failed = true;
    failed.inputs.front() = 47.0; // beyond all others, and of the study
    walls.levels.front().failed_walls.push_back(failed);
    const auto j = app::whatif_json(walls);
    REQUIRE(j["none"] == "");
    REQUIRE(j["inputs"].size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& input = j["inputs"][k];
        REQUIRE(input["values"].size() == app::kAskedValues);
        for (std::size_t i = 0; i < app::kAskedValues; ++i) {
            const double shown = input["values"][i];
            CHECK(input["coordinates"][i] ==
                  uq::coordinate(*walls.inputs[k].marginal, shown / walls.inputs[k].scale));
        }
    }
    CHECK(j["inputs"][0]["values"].front() == 20.0);
    CHECK(j["inputs"][0]["values"].back() == 47.0);
    CHECK(j["inputs"][0]["values"][j["inputs"][0]["start"].get<std::size_t>()] ==
          Approx(30.0).margin(1.0)); // near the median
    CHECK(j["factor"] == Approx(1.959964).epsilon(1e-6));
}

TEST_CASE("report what if: the page has the better surrogate of each stress, as the file of "
          "drystone surrogate has it",
          "[app][report_whatif]")
{
    const app::StudyWalls walls = asked_walls(30);
    const auto j = app::whatif_json(walls);
    REQUIRE(j["responses"].size() == 2);
    CHECK(j["responses"][0]["name"] == "peak force");
    CHECK(j["responses"][1]["name"] == "ultimate drift");
    const auto file =
        app::surrogate_data(app::surrogate_study(walls, app::wall_number("ultimate_drift")));
    for (std::size_t l = 0; l < 2; ++l) {
        const auto& level = j["responses"][1]["levels"][l];
        const auto& kept = file["surrogates"][l];
        const std::string better = kept["better"];
        CHECK(level["better"] == better);
        CHECK(level[better] == kept[better]);
        CHECK_FALSE(level.contains(better == "chaos" ? "process" : "chaos"));
        CHECK(level["doubts"] == kept["doubts"]);
        CHECK(level["learned_between"] == kept["learned_between"]);
        CHECK(j["modes"][l] == kept["modes"]);
        // half of the walls stood: what is learned is not theirs
        CHECK(level["doubts"].back().get<std::string>().find("walls outlast the push") !=
              std::string::npos);
        CHECK(level["left_out"].get<std::string>().find("What is learned holds for the") !=
              std::string::npos);
        CHECK(level["range"][0].get<double>() >= 100.0 * 0.015 / 1.1 * (1.0 - 1e-12));
    }
}

TEST_CASE("report what if: large studies are learned from their first walls, and it is said",
          "[app][report_whatif]")
{
    const auto j = app::whatif_json(asked_walls(app::kMostAskedWalls + 20));
    const auto& level = j["responses"][0]["levels"][0];
    CHECK(level["walls"] == app::kMostAskedWalls);
    CHECK(level["left_out"].get<std::string>().find(
              "learned from the first 200 walls; 20 more are in the file") !=
          std::string::npos);
    CHECK(j["modes"][0]["walls"] == app::kMostAskedWalls);
}

TEST_CASE("report what if: where nothing can be asked one sentence says why",
          "[app][report_whatif]")
{
    app::StudyWalls walls = asked_walls(30);
    std::string expected;
    SECTION("few walls")
    {
        walls = asked_walls(9);
        expected =
            "No wall can be predicted. Only 9 walls have the response; a surrogate needs "
            "at least 10.";
    }
    SECTION("the same on all walls")
    {
        for (app::StudyLevel& level : walls.levels)
            for (app::StudyWall& w : level.walls) {
                w.reading.peak = fragility::Peak{40e3, 0.01, false};
                w.reading.ultimate = {0.02, fragility::Reading::observed, ""};
            }
        expected = "No wall can be predicted. The response is the same on all walls: there is "
                   "nothing to learn.";
    }
    SECTION("nothing random")
    {
        for (app::StoredInput& input : walls.inputs)
            input.marginal = uq::Marginal{uq::Constant{1.0}};
        expected = "Nothing was random in this study, so that there is nothing to ask.";
    }
    SECTION("a file of an earlier version")
    {
        walls.inputs.back().marginal.reset();
        expected = "The distribution of unit.tensile_strength is not in the file, which is of "
                   "an earlier version; run the study again.";
    }
    SECTION("a field over the joints")
    {
        walls.inputs.front().count = 5;
        expected =
            "No wall can be predicted. Inputs vary from joint to joint (uq.spatial), and "
            "a surrogate takes one value per wall; run a study with uq.spatial = none "
            "for one. ";
    }
    const auto j = app::whatif_json(walls);
    CHECK(j["none"].get<std::string>().starts_with(expected));
    CHECK(j.size() == 1);
}
