#include "fragility/curve/resampled_curve.hpp"

#include <catch2/catch.hpp>

#include <vector>

TEST_CASE("resampled curve: straight between points, from the origin to the first, none beyond "
          "the last",
          "[fragility][resampled_curve]")
{
    const std::vector<double> d = {1.0, 2.0, 2.0, 4.0}, f = {10.0, 20.0, 12.0, 16.0};
    CHECK(fragility::resampled({d, f}, 0.5, 20) ==
          std::vector<double>{0, 5, 10, 15, 20, 13, 14, 15, 16});
    CHECK(fragility::resampled({d, f}, 0.5, 3) == std::vector<double>{0, 5, 10});
    CHECK(fragility::resampled({}, 0.5, 20).empty());
}
