#include "app/fragility/fragility_limits.hpp"

#include "app/fragility/fragility_curves.hpp"
#include "app/fragility_scenes.hpp"
#include "app/study/fragility_text.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using scenes::cell;

namespace {

const char* const kMedian = "median drift [%]";

std::string median_of(const std::vector<double>& drifts)
{
    const app::Table t = app::performance_table(scenes::drifts({drifts}));
    REQUIRE(t.rows.size() == 1);
    CHECK(scenes::sound(t));
    return cell(t, 0, kMedian);
}

} // namespace

TEST_CASE(
    "fragility limits: without censoring median and dispersion are those of the logarithms",
    "[app][fragility_limits]")
{
    const app::Table t = app::performance_table(scenes::drifts({{1.0, 2.0, 4.0, 2.0}}));
    CHECK(cell(t, 0, kMedian).starts_with("2.00 ["));
    const double beta = std::log(2.0) * std::sqrt(0.5);
    CHECK(std::stod(cell(t, 0, "dispersion")) == Approx(beta).margin(0.005));
    CHECK(std::stod(cell(t, 0, "statistical")) == Approx(beta / 2.0).margin(0.0005));
    CHECK(std::stod(cell(t, 0, "predictive")) ==
          Approx(std::hypot(beta, beta / 2.0)).margin(0.005));
    CHECK(std::stod(cell(t, 0, "84 % drift [%]")) ==
          Approx(2.0 * std::exp(0.99446 * beta)).margin(0.005));
}

TEST_CASE("fragility limits: data that carry no fit get a sentence and no number",
          "[app][fragility_limits]")
{
    CHECK(median_of({}) == "no wall gave a result");
    for (const std::vector<double>& few :
         {std::vector{1.0}, {1.0, 2.0}, {2.0, 2.0, 2.0}, {0.0, 1.0, 2.0}, {-2.5, -2.5, -2.5}}) {
        const app::Table t = app::performance_table(scenes::drifts({few}));
        CHECK(cell(t, 0, kMedian) == "not identifiable");
        CHECK_FALSE(cell(t, 0, "note").empty());
        for (const char* const empty :
             {"5 % drift [%]", "95 % drift [%]", "dispersion", "statistical", "predictive"})
            CHECK(cell(t, 0, empty).empty());
        CHECK(cell(t, 0, "n") == std::to_string(few.size()));
    }
}

TEST_CASE("fragility limits: five walls that stood bound the median, four do not",
          "[app][fragility_limits]")
{
    CHECK(median_of({-2.5, -2.5, -2.5, -2.5, -2.5}) == "not identifiable: median > 2.50");
    CHECK(median_of({-2.5, -2.5, -2.5, -2.5}).find("median >") == std::string::npos);
}

TEST_CASE("fragility limits: a bound is never rounded up", "[app][fragility_limits]")
{
    CHECK(median_of(std::vector(9, -2.7259)) == "not identifiable: median > 2.72");
}

TEST_CASE("fragility limits: walls that just reached the limit state bound the median by >=",
          "[app][fragility_limits]")
{
    CHECK(median_of(std::vector(9, 2.5)) == "not identifiable: median >= 2.50");
}

TEST_CASE(
    "fragility limits: drifts beyond the end of the walls are marked, those before are not",
    "[app][fragility_limits]")
{
    const app::DriftData data = scenes::drifts({{1.0, 1.4, 1.8, 2.2, 2.6, -2.7, -2.7, -2.7}});
    const app::Table t = app::performance_table(data);
    CHECK(cell(t, 0, "known to [%]") == "2.70");
    CHECK(cell(t, 0, "16 % drift [%]").find("†") == std::string::npos);
    const std::string high = cell(t, 0, "84 % drift [%]");
    CHECK(std::stod(high) > 2.7);
    CHECK(high.find("† [") != std::string::npos);
    CHECK(high.ends_with("†]"));
    CHECK(t.caption.find("†: extrapolated, beyond the largest drift") != std::string::npos);
    const app::Table plain = app::plain_numbers(t);
    CHECK(cell(plain, 0, "84 % drift extrapolated") == "1");
    CHECK(std::stod(cell(plain, 0, "84 % drift upper [%]")) > 2.7);
    CHECK(app::as_csv(plain).find("†") == std::string::npos);
    // a grid of drifts that goes as far as the walls do has no mark
    CHECK(app::as_text(app::curve_table(data, 0)).find("†") == std::string::npos);
}

TEST_CASE("fragility limits: a stress whose walls all stood has a marked median and no other",
          "[app][fragility_limits]")
{
    std::vector<std::vector<double>> groups(4);
    for (int g = 0; g < 4; ++g)
        for (int i = -4; i <= 4; ++i) {
            const double drift = 6.0 * std::exp(0.08 * i - 0.5 * g);
            groups[static_cast<std::size_t>(g)].push_back(drift < 4.2 ? drift : -4.2);
        }
    const app::Table t = app::stress_table(scenes::drifts(groups));
    REQUIRE(t.rows.size() == 7);
    CHECK(cell(t, 0, "median [%]").find("† [") != std::string::npos);
    CHECK(cell(t, 0, "known to [%]") == "4.20");
    CHECK(cell(t, 2, "median [%]").find("† [") == std::string::npos);
    // at the highest stress the walls ended below 4.2
    CHECK(std::stod(cell(t, 6, "known to [%]")) < 2.0);
    CHECK(cell(t, 6, "a wall from [%]").find("†") == std::string::npos);
}

TEST_CASE("fragility curves: drifts go to where all runs that end together still went",
          "[app][fragility_curves]")
{
    const auto end = [](const std::vector<double>& walls) {
        return app::drift_grid(scenes::drifts({walls}), 0, 30).back();
    };
    CHECK(end({1.0, -2.0, -2.7259, -2.7262, -2.7260}) == Approx(2.7259).epsilon(1e-12));
    CHECK(end({1.0, -2.7, 2.7001}) == Approx(2.7).epsilon(1e-12));
    CHECK(end({1.0, 2.6999, 2.7}) == Approx(2.7).epsilon(1e-12));
}

TEST_CASE("fragility curves: drifts beyond the walls of a stress are marked there alone",
          "[app][fragility_curves]")
{
    const app::Table t =
        app::curve_table(scenes::drifts({{1.0, 1.2, 1.4, 1.1}, {2.0, 2.4, 2.2, 2.8}}), 0);
    REQUIRE(t.rows.size() == 60);
    CHECK(cell(t, 14, "drift [%]") == "1.40");
    CHECK(cell(t, 15, "drift [%]") == "1.49†");
    for (std::size_t r = 30; r < 60; ++r)
        CHECK(cell(t, r, "drift [%]").find("†") == std::string::npos);
}

TEST_CASE("fragility limits: equal drifts have equal p-values, whichever limit state",
          "[app][fragility_limits]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0, 4.0, 2.0, 3.0, -3.9, -4.0}});
    data.states.push_back(data.states[0]);
    for (app::DriftWall& w : data.groups[0].walls) w.limits.push_back(w.limits[0]);
    const app::Table t = app::fit_table(data);
    REQUIRE(t.rows.size() == 2);
    CHECK_FALSE(cell(t, 0, "p of A2").empty()); // although runs ended apart
    CHECK(t.rows[0] == t.rows[1]);
}

TEST_CASE("fragility limits: the share censored is in the table", "[app][fragility_limits]")
{
    const auto t = app::performance_table(scenes::drifts({{1.0, 2.0, 3.0, -2.5}}));
    CHECK(cell(t, 0, "censored [%]") == "25");
}

TEST_CASE("fragility limits: captions say rule, law, confidence, censoring and failed walls",
          "[app][fragility_limits]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0, 3.0}});
    data.groups[0].failed = 2;
    data.groups[0].missing = 7;
    const std::string caption = app::performance_table(data).caption;
    for (const char* const part : {"drop to 80 % of the peak", "lognormal", "95 %", "censored",
                                   "3 walls, 2 failed, 7 not in this file"})
        CHECK(caption.find(part) != std::string::npos);
}

TEST_CASE("fragility limits: fits of degenerate data have a note and no statistics",
          "[app][fragility_limits]")
{
    const app::Table t = app::fit_table(
        scenes::drifts({{}, {1.0}, {2.0, 2.0, 2.0}, {-1.0, -1.0}, {0.0, 1.0, 2.0}}));
    CHECK(scenes::sound(t));
    for (std::size_t r = 0; r < t.rows.size(); ++r) {
        CHECK(cell(t, r, "p of D").empty());
        CHECK_FALSE(cell(t, r, "note").empty());
    }
}

TEST_CASE("fragility limits: the model over stresses says what it is asked at each level and "
          "between",
          "[app][fragility_limits]")
{
    std::vector<std::vector<double>> groups(3);
    for (int g = 0; g < 3; ++g)
        for (int i = -3; i <= 3; ++i)
            groups[static_cast<std::size_t>(g)].push_back(2.0 * std::exp(0.1 * i - 0.2 * g));
    const app::Table t = app::stress_table(scenes::drifts(groups));
    REQUIRE(t.rows.size() == 5);
    for (std::size_t r = 0; r < 5; ++r) // ln median falls by 0.2 per level
        CHECK(std::stod(cell(t, r, "median [%]")) ==
              Approx(2.0 * std::exp(-0.1 * static_cast<double>(r))).margin(0.006));
    const app::Table none = app::stress_table(scenes::drifts({{-1.0}, {-2.0}}));
    CHECK(cell(none, 0, "median [%]").starts_with("no model: "));
    CHECK(scenes::sound(none));
}

TEST_CASE("fragility curves: the fitted curve is one half at the median, steps are the shares",
          "[app][fragility_curves]")
{
    const auto data = scenes::drifts({{1.0, 2.0, 4.0, 2.0, -4.0}});
    const app::Table steps = app::step_table(data, 0);
    REQUIRE(steps.rows.size() == 3);
    CHECK(cell(steps, 0, "share").starts_with("0.2000"));
    CHECK(cell(steps, 1, "share").starts_with("0.6000"));
    CHECK(cell(steps, 2, "share").starts_with("0.8000"));
    const app::Table curve = app::curve_table(scenes::drifts({{1.0, 2.0, 4.0, 2.0}}), 0);
    CHECK(curve.rows.size() == 30);
    CHECK(cell(curve, 14, "drift [%]") == "2.00");
    CHECK(cell(curve, 14, "probability").starts_with("0.5000"));
}

TEST_CASE("fragility curves: degenerate data give sentences and pictures that can be drawn",
          "[app][fragility_curves]")
{
    const auto data =
        scenes::drifts({{}, {1.0}, {2.0, 2.0, 2.0}, {-1.0, -1.0}, {0.0, 1.0, 2.0}});
    const app::Table curve = app::curve_table(data, 0);
    CHECK(scenes::sound(curve));
    for (std::size_t r = 0; r < curve.rows.size(); ++r)
        CHECK(cell(curve, r, "probability").starts_with("no curve: "));
    CHECK(scenes::sound(app::step_table(data, 0)));
    CHECK(app::curve_pictures(data).size() == 5);
    CHECK(app::curve_pictures(scenes::drifts({{}})).empty());
}
