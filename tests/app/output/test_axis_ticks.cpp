#include "app/output/picture/axis_ticks.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using app::Axis;
using app::linear_axis;
using app::log_axis;
using app::tick_label;

TEST_CASE("axis ticks: linear ticks are round, even, and around the data", "[app][axis_ticks]")
{
    const double low = GENERATE(-3e6, -0.07, 0.0, 1e-7, 49.2);
    const double span = GENERATE(0.013, 1.0, 31.0, 7e8);
    const double high = low + span;
    const Axis axis = linear_axis(low, high);
    CAPTURE(low, high, axis.low, axis.high);
    const double step = axis.ticks.at(1) - axis.ticks.at(0);
    CHECK(axis.ticks.size() >= 4);
    CHECK(axis.ticks.size() <= 9);
    CHECK(axis.low <= low + 0.021 * step);
    CHECK(axis.high >= high - 0.021 * step);
    CHECK(axis.low > low - 1.001 * step);
    CHECK(axis.high < high + 1.001 * step);
    const double mantissa = step / std::pow(10.0, std::floor(std::log10(step * (1 + 1e-6))));
    CHECK((std::abs(mantissa - 1) < 1e-5 || std::abs(mantissa - 2) < 1e-5 ||
           std::abs(mantissa - 5) < 1e-5));
}

TEST_CASE("axis ticks: a range without width, or upside down, is still an axis",
          "[app][axis_ticks]")
{
    for (const double value : {0.0, 5.0, -2e-9}) {
        const Axis axis = linear_axis(value, value);
        CHECK(axis.low < value);
        CHECK(axis.high > value);
    }
    CHECK(log_axis(3.0, 3.0).low < 3.0);
    CHECK(log_axis(3.0, 3.0).high > 3.0);
    CHECK(linear_axis(10.0, 0.0).low == 0.0);
    CHECK(linear_axis(-3e6, -3e6 + 1e-9).ticks.size() < 10); // as good as equal
}

TEST_CASE("axis ticks: log axes of any width have three labels or more, inside",
          "[app][axis_ticks]")
{
    const double low = GENERATE(1e-8, 0.03, 1.0, 5000.0);
    const double ratio = GENERATE(1.1, 2.0, 7.0, 80.0, 1e4, 1e12);
    const Axis axis = log_axis(low, low * ratio);
    CAPTURE(low, ratio);
    CHECK(axis.ticks.size() >= 3);
    CHECK(axis.low < low);
    CHECK(axis.high > low * ratio);
    for (const double tick : axis.ticks) {
        CHECK(axis.share(tick) >= 0.0);
        CHECK(axis.share(tick) <= 1.0);
    }
}

TEST_CASE("axis ticks: equal factors are equal lengths on a log axis", "[app][axis_ticks]")
{
    const Axis axis = log_axis(1.0, 1000.0);
    CHECK(axis.share(axis.low) == 0.0);
    CHECK(axis.share(axis.high) == 1.0);
    CHECK(axis.share(100.0) - axis.share(10.0) == Approx(axis.share(10.0) - axis.share(1.0)));
    CHECK(linear_axis(0.0, 10.0).share(2.5) == 0.25);
}

TEST_CASE("axis ticks: labels of one axis have the same decimals", "[app][axis_ticks]")
{
    const Axis axis = linear_axis(0.0, 1.0);
    CHECK(tick_label(axis, axis.ticks.at(1)) == "0.2");
    CHECK(tick_label(axis, 1.0) == "1.0");
    CHECK(tick_label(axis, 0.0) == "0");
    const Axis fine = linear_axis(49.2, 49.3);
    CHECK(tick_label(fine, fine.ticks.at(0)) == "49.20");
    CHECK(tick_label(linear_axis(-30.0, 0.0), -10.0) == "-10");
}

TEST_CASE("axis ticks: large numbers are grouped, very large and small ones are powers",
          "[app][axis_ticks]")
{
    const Axis steps = log_axis(5000.0, 400000.0);
    CHECK(tick_label(steps, 5000.0) == "5000");
    CHECK(tick_label(steps, 20000.0) == "20\u2009000");
    CHECK(tick_label(steps, 200000.0) == "200\u2009000");
    CHECK(tick_label(log_axis(1e-6, 1.0), 1e-6) == "10⁻⁶");
    CHECK(tick_label(log_axis(1e-6, 1.0), 0.1) == "0.1");
    CHECK(tick_label(log_axis(1.0, 1e12), 2e10) == "2·10¹⁰");
    CHECK(tick_label(linear_axis(0.0, 5e9), 5e9) == "5·10⁹");
}
