#include "app/fragility/numbers/fragility_limits.hpp"
#include "app/fragility/numbers/limit_drifts.hpp"

#include "app/fragility/fragility_curves.hpp"
#include "app/fragility/numbers/drift_fits.hpp"
#include "tests/app/fragility/fragility_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

using scenes::cell;
using scenes::number_in;

namespace {

const char* const kMedian = "median drift [%]";

std::string median_of(const std::vector<double>& drifts)
{
    const app::Table t = app::performance_table(scenes::drifts({drifts}));
    REQUIRE(t.rows.size() == 1);
    CHECK(scenes::sound(t));
    return cell(t, 0, kMedian);
}

std::string note_of(const std::vector<double>& drifts)
{
    return cell(app::performance_table(scenes::drifts({drifts})), 0, "note");
}

} // namespace

TEST_CASE(
    "fragility limits: without censoring median and dispersion are those of the logarithms",
    "[app][fragility_limits]")
{
    const app::Table t = app::performance_table(scenes::drifts({{1.0, 2.0, 4.0, 2.0}}));
    CHECK(cell(t, 0, kMedian).starts_with("2.00 ["));
    const double beta = std::log(2.0) * std::sqrt(0.5);
    CHECK(number_in(t, 0, kMedian).value == Approx(2.0).epsilon(1e-12)); // all digits
    CHECK(number_in(t, 0, "dispersion").value == Approx(beta).epsilon(1e-6));
    CHECK(number_in(t, 0, "std error of ln median").value == Approx(beta / 2.0).epsilon(1e-6));
    CHECK(number_in(t, 0, "total dispersion").value ==
          Approx(std::hypot(beta, beta / 2.0)).epsilon(1e-6));
    CHECK(number_in(t, 0, "84 % drift [%]").value ==
          Approx(2.0 * std::exp(0.994457883209753 * beta)).epsilon(1e-6));
}

TEST_CASE("fragility limits: data that carry no fit get a note and no number",
          "[app][fragility_limits]")
{
    CHECK(note_of({}) == "No wall gave a result.");
    for (const std::vector<double>& few :
         {std::vector{1.0}, {1.0, 2.0}, {2.0, 2.0, 2.0}, {0.0, 1.0, 2.0}, {-2.5, -2.5, -2.5}}) {
        const app::Table t = app::performance_table(scenes::drifts({few}));
        CHECK(cell(t, 0, "note").starts_with("Not identifiable: "));
        CHECK(cell(t, 0, "note").find("not identifiable") == std::string::npos);
        for (const char* const empty :
             {kMedian, "5 % drift [%]", "95 % drift [%]", "dispersion",
              "std error of ln median", "total dispersion"})
            CHECK(cell(t, 0, empty).empty());
        CHECK(cell(t, 0, "n") == std::to_string(few.size()));
    }
}

TEST_CASE("fragility limits: five walls that stood bound the median, four do not",
          "[app][fragility_limits]")
{
    CHECK(median_of({-2.5, -2.5, -2.5, -2.5, -2.5}) == "> 2.50");
    CHECK(median_of({-2.5, -2.5, -2.5, -2.5}).empty());
}

TEST_CASE(
    "fragility limits: a bound is never rounded up, and programs get all of it as the lower "
    "bound of a median that is not known",
    "[app][fragility_limits]")
{
    CHECK(median_of(std::vector(9, -2.7259)) == "> 2.72");
    const app::Table t = app::performance_table(scenes::drifts({std::vector(9, -2.7259)}));
    const app::PlainTable p = app::plain(t);
    const auto at = [&](const std::string& head) {
        const auto found = std::find(p.head.begin(), p.head.end(), head);
        REQUIRE(found != p.head.end());
        return p.rows[0][static_cast<std::size_t>(found - p.head.begin())];
    };
    CHECK(std::holds_alternative<std::monostate>(at("median drift [%]")));
    CHECK(std::get<double>(at("median drift lower [%]")) == 2.7259);
    CHECK(std::holds_alternative<std::monostate>(at("median drift upper [%]")));
}

TEST_CASE("fragility limits: walls that just reached the limit state bound the median by >=",
          "[app][fragility_limits]")
{
    CHECK(median_of(std::vector(9, 2.5)) == ">= 2.50");
}

TEST_CASE("fragility limits: drifts beyond the end of the walls are lower bounds",
          "[app][fragility_limits]")
{
    const app::DriftData data = scenes::drifts({{1.0, 1.4, 1.8, 2.2, 2.6, -2.7, -2.7, -2.7}});
    const app::Table t = app::performance_table(data);
    CHECK(cell(t, 0, "tested up to [%]") == "2.70");
    CHECK(cell(t, 0, "drifts from") == "law, observed");
    CHECK(cell(t, 0, "16 % drift [%]").find("no limit") == std::string::npos);
    CHECK(cell(t, 0, "84 % drift [%]").starts_with("> 2."));
    CHECK(cell(t, 0, "note").find("shares above half of those reached") != std::string::npos);
    const app::PlainTable p = app::plain(t);
    const auto at = [&](const std::string& head) {
        const auto found = std::find(p.head.begin(), p.head.end(), head);
        REQUIRE(found != p.head.end());
        return p.rows[0][static_cast<std::size_t>(found - p.head.begin())];
    };
    CHECK(std::holds_alternative<std::monostate>(at("84 % drift [%]")));
    CHECK(std::get<double>(at("84 % drift censored")) == 1.0);
    CHECK(std::get<double>(at("84 % drift lower [%]")) <= 2.7);
    CHECK(std::holds_alternative<std::monostate>(at("84 % drift upper [%]")));
    CHECK(std::get<double>(at("16 % drift censored")) == 0.0);
}

TEST_CASE("fragility limits: two modes that fell give the drifts of their mixture",
          "[app][fragility_limits]")
{
    app::DriftData data = scenes::drifts({{}});
    data.modes = {"rocking", "mixed"};
    for (int i = -8; i <= 8; ++i) {
        const double x = std::exp(0.05 * i);
        data.groups[0].walls.push_back({1, {fragility::observed(1.5 * x * x)}});
        if (i % 2 == 0) data.groups[0].walls.push_back({0, {fragility::observed(9.0 * x)}});
    }
    const app::Table t = app::performance_table(data);
    CHECK(cell(t, 0, "drifts from") == "mixture");
    CHECK(number_in(t, 0, "95 % drift [%]").value > 9.0);
    CHECK(number_in(t, 0, "16 % drift [%]").value < 1.5);
    const double low = number_in(t, 0, "16 % drift [%]").value;
    const double high = number_in(t, 0, "84 % drift [%]").value;
    CHECK(number_in(t, 0, "dispersion").value ==
          Approx(std::log(high / low) / (2.0 * 0.994457883209753)).epsilon(1e-9));
    CHECK(app::pelicun_csv(data).find(
              "through the 16, 50 and 84 % drifts of the shares observed") !=
          std::string::npos);
    CHECK(scenes::sound(t));
}

TEST_CASE("fragility limits: a stress whose walls all stood has a lower bound of the median",
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
    CHECK(cell(t, 0, "median [%]").starts_with("> 4.20"));
    CHECK(cell(t, 0, "tested up to [%]") == "4.20");
    CHECK(std::isfinite(number_in(t, 2, "median [%]").value));
    // at the highest stress the walls ended below 4.2
    CHECK(number_in(t, 6, "tested up to [%]").value < 2.0);
    const app::Number next = number_in(t, 6, "prediction interval [%]");
    CHECK(next.lower < number_in(t, 6, "median [%]").value);
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
    data.states[0].rule = "one rule";
    data.states[1].rule = "another";
    for (app::DriftWall& w : data.groups[0].walls) w.limits.push_back(w.limits[0]);
    const app::Table t = app::fit_table(data);
    REQUIRE(t.rows.size() == 2);
    CHECK_FALSE(cell(t, 0, "p of A2").empty()); // although runs ended apart
    for (std::size_t c = 0; c < t.head.size(); ++c)
        CHECK(app::cell_text(t.rows[0][c]) == app::cell_text(t.rows[1][c]));
}

TEST_CASE("fragility limits: states of one rule have one row, with the names of both",
          "[app][fragility_limits]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0, 4.0, 2.0, 3.0}});
    data.states = {{"paper", "ultimate", "first drop"}, {"ec8", "NC", "first drop"}};
    for (app::DriftWall& w : data.groups[0].walls) w.limits.push_back(w.limits[0]);
    for (const app::Table& t : {app::performance_table(data), app::fit_table(data)}) {
        REQUIRE(t.rows.size() == 1);
        CHECK(cell(t, 0, "limit state") == "paper ultimate, ec8 NC");
    }
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
    CHECK(caption.find("(standard deviation of ln drift)") != std::string::npos);
    data.options.law = fragility::Law::weibull;
    CHECK(app::performance_table(data).caption.find("(1 / shape of the Weibull law)") !=
          std::string::npos);
    data.options.law = fragility::Law::gamma;
    CHECK(app::performance_table(data).caption.find(
              "(coefficient of variation of the drift)") != std::string::npos);
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
        CHECK(number_in(t, r, "median [%]").value ==
              Approx(2.0 * std::exp(-0.1 * static_cast<double>(r))).margin(0.006));
    const app::Table none = app::stress_table(scenes::drifts({{-1.0}, {-2.0}}));
    CHECK(cell(none, 0, "note").starts_with("No model: "));
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
        CHECK(cell(curve, r, "note").starts_with("No curve: "));
    CHECK(scenes::sound(app::step_table(data, 0)));
    CHECK(app::curve_pictures(data).size() == 5);
    CHECK(app::curve_pictures(scenes::drifts({{}})).empty());
}

TEST_CASE(
    "fragility laws: of uncensored drifts the parameters and their errors are the closed forms",
    "[app][fragility_laws]")
{
    const std::vector<double> drifts = {1.0, 2.0, 4.0, 2.0, 3.0, 1.5};
    const app::Table t = app::law_table(scenes::drifts({drifts}));
    REQUIRE(t.rows.size() == 4);
    const double n = static_cast<double>(drifts.size());
    const auto check_normal = [&](std::size_t row, auto f) {
        double mean = 0.0, square = 0.0;
        for (const double d : drifts) mean += f(d) / n;
        for (const double d : drifts) square += (f(d) - mean) * (f(d) - mean) / n;
        const double sd = std::sqrt(square);
        const app::Number first = number_in(t, row, "first value"),
                          second = number_in(t, row, "second value");
        CHECK(first.value == Approx(mean).epsilon(1e-6));
        CHECK(first.error == Approx(sd / std::sqrt(n)).epsilon(1e-5));
        CHECK(second.value == Approx(sd).epsilon(1e-6));
        CHECK(second.error == Approx(sd / std::sqrt(2.0 * n)).epsilon(1e-5));
        CHECK(number_in(t, row, "correlation").value == Approx(0.0).margin(1e-6));
    };
    check_normal(0, [](double d) { return std::log(d); });
    check_normal(1, [](double d) { return d; });
    // Weibull: where the likelihood is flat, sum x^k ln x / sum x^k - 1/k = mean ln x, scale^k
    // = mean x^k
    const double k = number_in(t, 2, "first value").value,
                 scale = number_in(t, 2, "second value").value;
    double xk = 0.0, xk_log = 0.0, logs = 0.0;
    for (const double d : drifts) {
        xk += std::pow(d, k) / n;
        xk_log += std::pow(d, k) * std::log(d) / n;
        logs += std::log(d) / n;
    }
    CHECK(xk_log / xk - 1.0 / k == Approx(logs).epsilon(1e-6));
    CHECK(std::pow(scale, k) == Approx(xk).epsilon(1e-6));
    // gamma: shape times scale is the mean, and its error that of ln mean, 1 / sqrt(n shape)
    const app::Number shape = number_in(t, 3, "first value"),
                      theta = number_in(t, 3, "second value");
    CHECK(shape.value * theta.value == Approx(13.5 / n).epsilon(1e-6));
    const double a = shape.error / shape.value, b = theta.error / theta.value;
    const double ln_mean = a * a + b * b + 2.0 * a * b * number_in(t, 3, "correlation").value;
    CHECK(ln_mean == Approx(1.0 / (n * shape.value)).epsilon(1e-4));
}

TEST_CASE("fragility laws: a law that cannot be fitted has a note and no parameters",
          "[app][fragility_laws]")
{
    const app::Table t = app::law_table(scenes::drifts({{0.0, 1.0, 2.0}}));
    CHECK(scenes::sound(t));
    CHECK(cell(t, 0, "first value").empty()); // lognormal: a drift of zero
    CHECK(cell(t, 0, "note").starts_with("No fit: "));
    CHECK(cell(t, 1, "law") == "normal");
    CHECK(number_in(t, 1, "first value").value == Approx(1.0).epsilon(1e-6));
}

TEST_CASE(
    "fragility limits: a law that the tests reject is marked in the limits, another is not",
    "[app][fragility_limits]")
{
    std::vector<double> three_heaps, one;
    for (int i = 0; i < 20; ++i) {
        three_heaps.push_back(1.0 + 0.001 * i);
        three_heaps.push_back(i < 10 ? 2.0 + 0.001 * i : 3.0 + 0.003 * i);
        one.push_back(2.0 * std::exp(0.1 * (i - 9.5) / 5.0));
    }
    app::DriftData data = scenes::drifts({three_heaps, one});
    data.options.bootstrap = 199;
    app::judge(data);
    const app::Table limits = app::performance_table(data);
    CHECK(cell(limits, 0, "note")
              .starts_with("The fitted curve does not describe the walls (p = 0.005)"));
    CHECK(cell(limits, 1, "note").empty());
    CHECK(cell(limits, 0, "drifts from") == "observed");
    CHECK(cell(limits, 1, "drifts from") == "law");
    // values that were seen, not those of a law between the heaps
    CHECK(number_in(limits, 0, "5 % drift [%]").value == 1.001);
    CHECK(number_in(limits, 0, "median drift [%]").value == 1.019);
    CHECK(number_in(limits, 0, "84 % drift [%]").value >= 3.0);
    CHECK(cell(limits, 0, "dispersion").empty());
    // the same in the curves, the pictures, the model and the file for pelicun
    const app::Table curve = app::curve_table(data, 0);
    for (std::size_t r = 0; r < curve.rows.size(); ++r) {
        if (cell(curve, r, "stress [MPa]") != cell(curve, 0, "stress [MPa]")) continue;
        const double drift = number_in(curve, r, "drift [%]").value;
        if (drift > 1.05 && drift < 1.95)
            CHECK(number_in(curve, r, "probability").value == Approx(0.5));
    }
    CHECK(app::curve_pictures(data)[0].svg.find("(observed)") != std::string::npos);
    CHECK(cell(app::stress_table(data), 0, "note").starts_with("No model: "));
    const std::string pelicun = app::pelicun_csv(data);
    CHECK(pelicun.find(",1,Peak Interstory Drift Ratio") != std::string::npos);
    CHECK(pelicun.find("the tests reject the lognormal law (p = 0.005)") != std::string::npos);
    CHECK(
        cell(app::law_table(data), 0, "note").starts_with("The goodness-of-fit tests reject"));
}

TEST_CASE("fragility limits: fits made once give the tables that each makes for itself",
          "[app][fragility_limits]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0, 4.0, 2.0, 3.0, -3.9}, {2.0, 1.0, 1.5}});
    data.options.bootstrap = 20;
    const std::string apart = app::as_csv(app::fit_table(data));
    std::vector<double> told;
    app::judge(data, [&](double done, const std::string& fit) {
        told.push_back(done);
        CHECK(fit.starts_with(told.size() <= 20 ? data.groups[0].name : data.groups[1].name));
    });
    CHECK(app::as_csv(app::fit_table(data)) == apart);
    REQUIRE(told.size() == 40); // of each of the samples of both fits
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.front() == 0.0);
    CHECK(told.back() == Approx(0.975));
}

TEST_CASE("fragility limits: drifts chosen once give the tables that each makes for itself",
          "[app][fragility_limits]")
{
    app::DriftData data = scenes::drifts({{1.0, 2.0, 4.0, 2.5, 3.0}, {2.0, 1.0, 1.5}});
    data.options.bootstrap = 20;
    data.states.push_back(data.states.front());
    for (app::DriftGroup& group : data.groups)
        for (app::DriftWall& wall : group.walls)
            wall.limits.push_back(fragility::observed(2.0 * wall.limits.front()->lower + 1.0));
    const std::string limits = app::as_csv(app::performance_table(data)),
                      pelicun = app::pelicun_csv(data);
    app::choose_limits(data);
    REQUIRE(data.groups.front().limits.size() == 2);
    CHECK(app::as_csv(app::performance_table(data)) == limits);
    CHECK(app::pelicun_csv(data) == pelicun);
}
