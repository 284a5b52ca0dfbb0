#include "dem/solver/stop_rules.hpp"

#include <catch2/catch.hpp>

#include <vector>

namespace {

std::vector<dem::CurvePoint> curve_of(const std::vector<double>& forces)
{
    std::vector<dem::CurvePoint> curve;
    for (const double force : forces) curve.emplace_back().force = force;
    return curve;
}

} // namespace

TEST_CASE("stop rules: a push ends below a share of its peak, in its own direction",
          "[dem][stop_rules]")
{
    const dem::StopRule right = dem::stop_below(0.5), left = dem::stop_below(0.5, -1);
    CHECK_FALSE(right(curve_of({0.0})));
    CHECK_FALSE(right(curve_of({0.0, 10.0, 5.0})));
    CHECK(right(curve_of({0.0, 10.0, 4.9})));
    CHECK_FALSE(right(curve_of({0.0, -3.0, -1.0}))); // has not resisted yet
    CHECK(left(curve_of({0.0, -10.0, -4.9})));
}

TEST_CASE("stop rules: a wall that never carried anything is pushed on", "[dem][stop_rules]")
{
    const dem::StopRule stop = dem::at_zero_force();
    CHECK_FALSE(stop(curve_of({0.0, 0.0})));
    CHECK_FALSE(stop(curve_of({0.0, 10.0, 1.0})));
    CHECK(stop(curve_of({0.0, 10.0, -1.0})));
    CHECK(dem::at_zero_force(-1)(curve_of({0.0, -10.0, 0.0})));
}
