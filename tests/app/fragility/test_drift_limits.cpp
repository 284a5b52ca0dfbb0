#include "app/fragility/fragility_curves.hpp"
#include "app/fragility/numbers/drift_fits.hpp"
#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/study_output.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

using scenes::cell;

namespace {

const char* const kMedian = "median drift [%]";

/// Walls of one stress: this many at each drift limit, and others with drifts of their own
/// (negative: stopped there).
app::DriftData limited(const std::vector<std::pair<double, int>>& limits,
                       const std::vector<double>& others = {})
{
    app::DriftData data = scenes::drifts({others});
    for (const auto& [drift, walls] : limits)
        for (int i = 0; i < walls; ++i)
            data.groups[0].walls.push_back(
                {-1, {fragility::Observation{drift, drift, 1.0, true}}});
    return data;
}

} // namespace

TEST_CASE("drift limits: a drift limit of the code is a plain number in every output",
          "[app][drift_limits]")
{
    const app::DriftData data = limited({{1.0, 20}});
    const app::Table t = app::performance_table(data);
    CHECK(cell(t, 0, "note") == "cap of the code (1.00 %): 100 % of walls.");
    CHECK(cell(t, 0, "drifts from") == "limit");
    for (const char* const share : {"5 % drift [%]", kMedian, "95 % drift [%]"})
        CHECK(cell(t, 0, share) == "1.00");
    CHECK(cell(t, 0, "dispersion").empty());
    CHECK(app::curve_pictures(data).empty());
    CHECK(cell(app::step_table(data, 0), 0, "share") == "1.0000");
    for (const app::Table& other :
         {app::curve_table(data, 0), app::law_table(data), app::fit_table(data)}) {
        CHECK(cell(other, 0, "note")
                  .find("a drift limit that is set comes first for 20 of 20 walls") !=
              std::string::npos);
        CHECK(scenes::sound(other));
    }
    CHECK(cell(app::stress_table(data), 0, "note").starts_with("No model: a drift limit"));
    CHECK(app::pelicun_csv(data).find("ntc SLC: cap of the code (1.00 %): 100 % of walls") !=
          std::string::npos);
}

TEST_CASE("drift limits: two limits of the code have their counts, and no interval",
          "[app][drift_limits]")
{
    const app::Table t = app::performance_table(limited({{0.5, 10}, {1.0, 40}}));
    app::DriftData both = limited({{0.5, 10}, {1.0, 40}});
    both.groups.push_back(scenes::drifts({{1.0, 2.0, 4.0}}).groups[0]);
    const auto pictures = app::curve_pictures(both);
    REQUIRE(pictures.size() == 2);
    CHECK(pictures[0].title.ends_with("left out, since it reached drift limits alone: " +
                                      both.groups[0].name));
    CHECK(cell(t, 0, "note") ==
          "cap of the code (0.500 %): 20 % of walls, (1.00 %): 80 % of walls.");
    CHECK(cell(t, 0, "5 % drift [%]") == "0.500");
    CHECK(cell(t, 0, kMedian) == "1.00");
    CHECK(cell(t, 0, "95 % drift [%]") == "1.00");
}

TEST_CASE("drift limits: where some walls fell before the limit of the code, drifts are those "
          "observed",
          "[app][drift_limits]")
{
    const app::DriftData data = limited({{1.0, 12}}, {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85, 0.9});
    const app::Table t = app::performance_table(data);
    CHECK(cell(t, 0, "note") == "cap of the code (1.00 %): 60 % of walls; 8 of 20 fell before: "
                                "the drifts are those observed (Kaplan-Meier), no law.");
    CHECK(cell(t, 0, "drifts from") == "observed");
    CHECK(cell(t, 0, "16 % drift [%]").starts_with("0.600 [")); // fourth of twenty
    CHECK(cell(t, 0, kMedian) == "1.00");
    CHECK_FALSE(app::curve_pictures(data).empty());
    CHECK(cell(app::step_table(data, 0), 0, "share").starts_with("0.0500 ["));
}

TEST_CASE("drift limits: a wall pushed too little for the limit of the code has none of it",
          "[app][drift_limits]")
{
    const app::Table t = app::performance_table(limited({{1.0, 3}}, {-0.6, -0.6}));
    CHECK(cell(t, 0, "note") == "cap of the code (1.00 %): 60 % of walls.");
    CHECK(cell(t, 0, "censored [%]") == "40");
    CHECK(cell(t, 0, kMedian) == "1.00");
}

TEST_CASE("drift limits: the user's limit is not called the code's", "[app][drift_limits]")
{
    app::DriftData data = limited({{2.0, 4}});
    data.states[0] = {"user", "far", "at most 2 % drift"};
    CHECK(cell(app::performance_table(data), 0, "note") ==
          "limit given (2.00 %): 100 % of walls.");
}

TEST_CASE(
    "drift limits: a terminal gets ten rows, those of the severest states of a long table",
    "[app][drift_limits]")
{
    const auto answer = [](std::size_t stresses) {
        app::DriftData data = scenes::drifts(std::vector(stresses, std::vector{1.0, 2.0, 4.0}));
        data.states = {{"paper", "ultimate", "a"}, {"ntc", "SLV", "b"}, {"ntc", "SLC", "c"}};
        for (app::DriftGroup& g : data.groups)
            for (app::DriftWall& w : g.walls) w.limits.assign(3, w.limits[0]);
        const app::FragilityOutput output = app::drift_output(data);
        CHECK(output.tables[0].table.rows.size() == 3 * stresses);
        return app::short_table(output.tables[0]);
    };
    CHECK(answer(3).rows.size() == 9);
    CHECK(answer(12).rows.size() == app::kShortRows);
    const app::Table five = answer(5);
    REQUIRE(five.rows.size() == 10);
    for (std::size_t r = 0; r < 10; ++r)
        CHECK(cell(five, r, "limit state") == (r % 2 == 0 ? "paper ultimate" : "ntc SLC"));
    CHECK(cell(five, 0, kMedian).starts_with("2.00"));
    for (const app::Head& h : five.head) CHECK(h.name != "5 % drift [%]");
}
