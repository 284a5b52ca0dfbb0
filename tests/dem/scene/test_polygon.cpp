#include "dem/scene/geometry/polygon.hpp"

#include <catch2/catch.hpp>

#include <vector>

TEST_CASE("polygon: the extent is the smallest rectangle, and joining two holds both",
          "[dem][polygon]")
{
    const std::vector<dem::Point> triangle = {{0.5, 0.0}, {0.8, 0.1}, {0.4, 0.3}};
    CHECK(dem::extent_of(triangle) == dem::Region{0.4, 0.0, 0.8, 0.3});
    CHECK(dem::extent_of({triangle.data(), 1}) == dem::Region{0.5, 0.0, 0.5, 0.0});
    CHECK(dem::join({0.4, 0.0, 0.8, 0.3}, {-1.0, 0.1, 0.5, 0.2}) ==
          dem::Region{-1.0, 0.0, 0.8, 0.3});
}
