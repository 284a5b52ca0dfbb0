#include "app/fragility_limits.hpp"

#include "app/fragility_curves.hpp"
#include "app/fragility_scenes.hpp"

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
    CHECK(median_of({-2.5, -2.5, -2.5, -2.5, -2.5}).find("median > 2.50") != std::string::npos);
    CHECK(median_of({-2.5, -2.5, -2.5, -2.5}).find("median >") == std::string::npos);
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
                                   "3 walls, 2 failed, 7 not run yet"})
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

TEST_CASE("fragility curves: neither a mixture nor its band falls with the drift",
          "[app][fragility_curves]")
{
    app::DriftData data = scenes::drifts({{}});
    data.modes = {"rocking", "mixed"};
    for (int i = 0; i < 30; ++i) { // far apart: the tails are deep
        const double spread = std::exp(0.1 * (i % 5 - 2));
        data.groups[0].walls.push_back({i % 2, {fragility::observed((i % 2 + 0.1) * spread)}});
    }
    std::vector<double> drifts;
    for (int i = 1; i <= 200; ++i) drifts.push_back(0.02 * i);
    const auto points =
        app::mixture_points(data, app::mode_groups(data, data.groups[0], 0), drifts);
    for (std::size_t i = 1; i < points.size(); ++i) {
        CHECK(points[i].least >= points[i - 1].least);
        CHECK(points[i].band.lower >= points[i - 1].band.lower);
        CHECK(points[i].band.upper >= points[i - 1].band.upper);
    }
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
