#include "app/reading/wall_numbers.hpp"

#include "app/output/table/table.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/text/number_text.hpp"
#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>
#include <string>

namespace {

using app::wall_number;

/// A wall whose force had fallen to no share of its peak when the push ended at 8 mm.
app::WallReading standing()
{
    app::WallReading w;
    w.peak = fragility::Peak{50e3, 8e-3, true};
    w.ultimate = {8e-3, fragility::Reading::censored, {}};
    w.collapse = w.ultimate;
    return w;
}

} // namespace

TEST_CASE("wall numbers: docs/numbers.md is current", "[app][wall_numbers]")
{
    INFO("write it anew: ./drystone help numbers > docs/numbers.md");
    CHECK(scenes::read_text(std::string(DRYSTONE_SOURCE_DIR) + "/docs/numbers.md") ==
          app::numbers_page());
}

TEST_CASE("wall numbers: each name stands for one reading or one fact", "[app][wall_numbers]")
{
    std::set<std::string> names, keys, heads;
    for (const app::WallNumber& n : app::kWallNumbers) {
        INFO(n.name);
        CHECK(names.insert(std::string(n.name)).second);
        CHECK(keys.insert(app::summary_key(n)).second);
        CHECK(heads.insert(app::head_text(n)).second);
        CHECK((n.reading != nullptr) != (n.fact != nullptr));
        if (!n.old_key.empty()) CHECK(keys.insert(std::string(n.old_key)).second);
    }
    for (std::size_t i = 0; i < app::kJudged; ++i) {
        INFO(app::kWallNumbers[i].name);
        REQUIRE(app::kWallNumbers[i].reading != nullptr);
        CHECK(app::kWallNumbers[i].is_bound != nullptr);
    }
}

TEST_CASE("wall numbers: keys and heads end with the unit that is shown", "[app][wall_numbers]")
{
    CHECK(app::summary_key(wall_number("peak_force")) == "peak_force_kN");
    CHECK(app::summary_key(wall_number("secant_stiffness")) == "secant_stiffness_kN_per_mm");
    CHECK(app::summary_key(wall_number("ultimate_drift")) == "ultimate_drift_percent");
    CHECK(app::summary_key(wall_number("steps")) == "steps");
    CHECK(app::head_text(wall_number("peak_displacement")) == "at peak [mm]");
    CHECK(app::head_text(wall_number("cracked_units")) == "cracked units");
}

TEST_CASE("wall numbers: a bound is marked where the column holds bounds",
          "[app][wall_numbers]")
{
    const app::WallReading w = standing();
    const auto text = [&](const app::WallNumber& n, unsigned holds) {
        return app::cell_text(app::number_cell(n, w, 1.6, holds));
    };
    CHECK(text(wall_number("ultimate_displacement"), app::kCensored) == "> 8.00");
    CHECK(text(wall_number("ultimate_drift"), app::kCensored) == "> 0.50");
    CHECK(text(wall_number("ultimate_drift"), 0) == "0.50");
    CHECK(text(wall_number("peak_force"), 0) == "50.00");
    CHECK(text(wall_number("secant_stiffness"), app::kCensored).empty());
}

TEST_CASE(
    "wall numbers: forces and stiffness of a model as large as a hand are not rounded away",
    "[app][wall_numbers]")
{
    const auto text = [](const app::WallNumber& n, double si) {
        return app::cell_text(app::number_cell(n, si));
    };
    CHECK(text(wall_number("peak_force"), 46.91e3) == "46.91");
    CHECK(text(wall_number("peak_force"), 120.0) == "0.12");
    CHECK(text(wall_number("peak_force"), 7.06) == "0.0071");
    CHECK(text(wall_number("peak_force"), 0.1766) == "0.00018");
    CHECK(text(wall_number("peak_force"), -0.1766) == "-0.00018");
    CHECK(text(wall_number("peak_force"), 4e-9) == "0.00"); // rounding of a sum
    CHECK(text(wall_number("peak_force"), 0.0) == "0.00");
    CHECK(text(wall_number("secant_stiffness"), 7063.0) == "0.0071");
    CHECK(text(wall_number("settlement"), 3.6e-9) ==
          app::fixed(0.0, wall_number("settlement").decimals));
}

TEST_CASE("wall numbers: a wall that came down before it was pushed has no solver error",
          "[app][wall_numbers]")
{
    app::PushedWall w;
    w.result.outcome = dem::Outcome::lost_equilibrium;
    w.result.solver_error = 0.0;
    CHECK(std::isnan(app::solver_error(w)));
    w.displacement = {0.0, 1e-3};
    CHECK(app::solver_error(w) == 0.0);
}

TEST_CASE("wall numbers: a fact that no file holds is refused, not invented",
          "[app][wall_numbers]")
{
    const app::WallReading w = standing();
    const dem::Mechanism mechanism;
    const app::WallSource stored{w, 1.6, mechanism, 0.01, 0.02};
    CHECK(app::value(wall_number("solver_error"), stored) == 0.01);
    CHECK(app::value(wall_number("points_error"), stored) == 0.02);
    CHECK_THROWS_AS(app::value(wall_number("steps"), stored), std::logic_error);
}
