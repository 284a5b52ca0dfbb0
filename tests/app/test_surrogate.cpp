#include "app/surrogate/surrogate_fit.hpp"

#include "tests/uq/latin_scene.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace app;

namespace {

SurrogatePoints points(int n, int d)
{
    SurrogatePoints p;
    p.coordinates = 2.0 * scenes::latin_hypercube(n, d, 5).array() - 1.0;
    p.x = p.coordinates;
    for (int i = 0; i < n; ++i) p.sample.push_back(static_cast<std::uint32_t>(i));
    p.y = 50.0 + 5.0 * p.x.col(0).array() + p.x.col(1).array().square();
    return p;
}

LevelSurrogate fitted(SurrogatePoints p, bool dependent = false)
{
    const std::vector<uq::PolynomialFamily> families(static_cast<std::size_t>(p.x.cols()),
                                                     uq::PolynomialFamily::legendre);
    return fit_surrogate(std::move(p), families, dependent, 1);
}

} // namespace

TEST_CASE("surrogate: a smooth response is learned and trusted", "[app][surrogate]")
{
    const LevelSurrogate s = fitted(points(60, 3));
    CHECK(s.doubts.empty());
    CHECK(s.no_indices.empty());
    CHECK(s.chaos_error.q2 > 0.9999);
    CHECK(s.process_error.q2 > 0.999);
    CHECK((s.left_out - s.points.y).norm() < 0.01 * s.points.y.norm());
    REQUIRE(s.given.size() == 3);
    CHECK(s.given[0].p_value < kDependsLevel);
    CHECK(s.given[0].rank.has_value());
    CHECK(s.given[0].hsic.has_value());
    CHECK(s.given[2].p_value > kDependsLevel); // the third input does nothing
    CHECK_FALSE(s.given[2].rank.has_value()); // and has no index, whatever the estimate is
    CHECK_FALSE(s.given[2].hsic.has_value());
}

TEST_CASE("surrogate: doubts are said in words, and no index is given", "[app][surrogate]")
{
    SurrogatePoints p = points(60, 3);
    std::string expected;
    SECTION("constant")
    {
        p.y.setConstant(7.0);
        expected = "same on all walls";
    }
    SECTION("three walls")
    {
        p = points(3, 2);
        expected = "Only 3 walls";
    }
    SECTION("ten inputs")
    {
        p = points(40, 10);
        expected = "fewer than 5 for each of 10";
    }
    SECTION("noise")
    {
        uq::Stream s(3, 0, uq::Purpose::monte_carlo);
        for (double& y : p.y) y = s.normal();
        expected = "less than half of the variance";
    }
    SECTION("two heaps that the inputs do not tell apart")
    {
        uq::Stream s(3, 0, uq::Purpose::monte_carlo);
        for (double& y : p.y) y = 20.0 * static_cast<double>(s.below(2)) + s.normal();
        expected = "two heaps";
    }
    const LevelSurrogate s = fitted(p);
    REQUIRE_FALSE(s.doubts.empty());
    CHECK(s.doubts.back().find(expected) != std::string::npos);
    CHECK_FALSE(s.no_indices.empty());
}

TEST_CASE("surrogate: dependent inputs have no shares of the variance", "[app][surrogate]")
{
    const LevelSurrogate s = fitted(points(60, 3), true);
    CHECK(s.doubts.empty());
    CHECK(s.no_indices.find("depend on each other") != std::string::npos);
}

TEST_CASE("surrogate: inputs without coordinates have indices from the walls alone",
          "[app][surrogate]")
{
    SurrogatePoints p = points(60, 3);
    p.no_coordinates = "Inputs vary from joint to joint.";
    const LevelSurrogate s = fitted(p);
    CHECK_FALSE(s.chaos);
    CHECK_FALSE(s.process);
    CHECK(s.doubts == std::vector<std::string>{p.no_coordinates});
    CHECK(s.no_indices == p.no_coordinates);
    REQUIRE(s.given.size() == 3);
    CHECK(s.given[0].rank.has_value());
    CHECK(s.given[0].hsic.has_value());
}

TEST_CASE("surrogate: an unknown response is named with those that there are",
          "[app][surrogate]")
{
    CHECK(surrogate_response("ultimate_drift").unit.name == "%");
    CHECK_THROWS_WITH(surrogate_response("peak_forse"),
                      Catch::Contains("--of") && Catch::Contains("peak_force"));
}
