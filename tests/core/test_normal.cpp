#include "core/normal.hpp"

#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using namespace core;

namespace {

struct Point {
    double p, x;
};

// mpmath, 40 digits, at the double p; on both sides of the joints 0.075 and exp(-25).
const std::vector<Point> kPoints = {
    {1e-300, -37.047096299361199237},       {1e-250, -33.79958617269483747},
    {1e-200, -30.205594179579643063},       {1e-120, -23.334075067341868216},
    {1e-60, -16.39727821271871048},         {1e-30, -11.46402468844361572},
    {1e-20, -9.2623400897984075796},        {1e-15, -7.9413453261709967713},
    {1e-12, -7.0344838253011319326},        {1.3887e-11, -6.6579146354625080615},
    {1.389e-11, -6.6578828791058745545},    {1e-8, -5.6120012441747887279},
    {1e-4, -3.7190164854556805523},         {0.01, -2.3263478740408410931},
    {0.0749, -1.4402382675279636631},       {0.075, -1.4395314709384559349},
    {0.0751, -1.4388253927525399824},       {0.1, -1.2815515655446004353},
    {0.25, -0.6744897501960817432},         {0.3, -0.52440051270804081597},
    {0.4375, -0.15731068461017069552},      {0.49, -0.025068908258711058033},
    {0.499999, -2.5066282745665593779e-6},  {1.0 - 0.375, 0.31863936396437516302},
    {1.0 - 0.125, 1.1503493803760081783},   {1.0 - 0x1p-7, 2.4175590162365050618},
    {1.0 - 0x1p-40, 7.0477002566644087254}, {1.0 - 0x1p-53, 8.2095361516013868556}};

/// Smallest step of the quantile against its size as p grows by the factor 1 + `step` at a
/// time, 200 times from below to above `joint`.
double least_step(double joint, double step)
{
    double least = 1.0;
    double before = normal_quantile(joint * std::pow(1.0 + step, -100));
    for (int k = -99; k <= 100; ++k) {
        const double x = normal_quantile(joint * std::pow(1.0 + step, k));
        least = std::min(least, (x - before) / std::abs(x));
        before = x;
    }
    return least;
}

} // namespace

TEST_CASE("normal: the quantile: 15 digits from 1e-300 to 1 - 1e-16", "[core][normal]")
{
    for (const Point& r : kPoints) {
        CAPTURE(r.p);
        CHECK(std::abs(normal_quantile(r.p) / r.x - 1.0) < 1e-15);
        if (r.p < 0.5) CHECK(std::abs(upper_normal_quantile(r.p) / r.x + 1.0) < 1e-15);
    }
    CHECK(normal_quantile(0.5) == 0.0);
}

TEST_CASE("normal: the quantile: both sides are the same but for the sign, to the bit",
          "[core][normal]")
{
    uq::Stream s(1, 0, uq::Purpose::search);
    for (int i = 0; i < 10000; ++i) {
        const double p = s.uniform(); // 1 - p is exact
        CHECK(normal_quantile(1.0 - p) == -normal_quantile(p));
        CHECK(upper_normal_quantile(p) == normal_quantile(1.0 - p));
    }
}

TEST_CASE(
    "normal: the quantile: rises through the joints of its regions and to the ends of double",
    "[core][normal]")
{
    // Steps of about 1e-14 of the quantile: some ten times what its last digits are good for.
    CHECK(least_step(0.075, 2.7e-14) > 5e-15);
    CHECK(least_step(std::exp(-25.0), 4.5e-13) > 5e-15);
    const double least = std::numeric_limits<double>::denorm_min();
    CHECK(normal_quantile(least) == Approx(-38.467405617144344).epsilon(1e-14));
    double before = normal_quantile(least);
    for (double p = 1e-307; p < 0.5; p *= 1.01) {
        const double x = normal_quantile(p);
        CHECK(x > before);
        before = x;
    }
}

TEST_CASE("normal: the quantile: many at once have the bits of one by one, for all lengths",
          "[core][normal]")
{
    const std::size_t n = GENERATE(0u, 1u, 7u, 8u, 9u, 255u, 256u, 257u, 5000u);
    uq::Stream s(2, n, uq::Purpose::search);
    std::vector<double> p(n);
    for (double& x : p) x = s.below(3) == 0 ? std::exp(-700.0 * s.uniform()) : s.uniform();
    std::vector<double> x = p;
    to_normal_quantiles(x);
    for (std::size_t i = 0; i < n; ++i) CHECK(x[i] == normal_quantile(p[i]));
}

TEST_CASE("normal: the quantile: what is no probability inside (0, 1) is refused",
          "[core][normal]")
{
    const double bad =
        GENERATE(0.0, 1.0, -0.1, 1.1, std::nan(""), std::numeric_limits<double>::infinity());
    CHECK_THROWS_AS(normal_quantile(bad), std::invalid_argument);
    CHECK_THROWS_AS(upper_normal_quantile(bad), std::invalid_argument);
    std::vector<double> p{0.5, bad, 0.25};
    CHECK_THROWS_WITH(to_normal_quantiles(p), Catch::Contains("is not in (0, 1)"));
}
