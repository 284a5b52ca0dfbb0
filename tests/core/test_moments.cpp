#include "core/moments.hpp"

#include "tests/core/nist_sets.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

using namespace core;

namespace {

auto near(double value, double relative) { return Approx(value).epsilon(relative).margin(0.0); }

} // namespace

TEST_CASE("moments: mean and standard deviation of the NIST sets to the certified digits",
          "[core][moments]")
{
    for (const auto& set :
         {scenes::lew(), scenes::lottery(), scenes::mavro(), scenes::michelso()}) {
        INFO(set.name);
        const Moments m = moments(set.y);
        CHECK(m.mean == near(set.mean, 1e-14));
        // Certified to 15 digits; Mavro and Michelso are stored as doubles, whose rounding
        // (1e-16 of the data) is 2e-12 and 7e-13 of the deviations.
        CHECK(m.sd == near(set.sd, set.sd / set.mean > 0.1 || set.mean < 0.0 ? 1e-14 : 2e-13));
    }
}

TEST_CASE("moments: NumAcc 1 to 4, as far as doubles hold the data", "[core][moments]")
{
    const std::vector<double> integers{10000001.0, 10000003.0, 10000002.0};
    CHECK(moments(integers).mean == 10000002.0);
    CHECK(moments(integers).sd == 1.0);
    const auto two = moments(scenes::alternating(1.2, 1.1, 1.3));
    CHECK(two.mean == near(1.2, 1e-15));
    CHECK(two.sd == near(0.1, 1e-15));
    // 0.1 and 0.3 above 1e6 (1e7) are off by up to 5.8e-11 (9.3e-10).
    const auto three = moments(scenes::alternating(1000000.2, 1000000.1, 1000000.3));
    CHECK(three.mean == near(1000000.2, 1e-15));
    CHECK(three.sd == near(0.1, 1e-9));
    const auto four = moments(scenes::alternating(10000000.2, 10000000.1, 10000000.3));
    CHECK(four.mean == near(10000000.2, 1e-15));
    CHECK(four.sd == near(0.1, 1e-8));
}

TEST_CASE("moments: of the doubles that stand for NumAcc 3 and 4 it is exact",
          "[core][moments]")
{
    // Two values a, b, 500 each, and one c: in differences from c, exact in double.
    const double base = GENERATE(1000000.0, 10000000.0);
    const double a = base + 0.1, b = base + 0.3, c = base + 0.2;
    const long double da = a - c, db = b - c, mean = 500.0L * (da + db) / 1001.0L;
    const long double squares =
        500.0L * ((da - mean) * (da - mean) + (db - mean) * (db - mean)) + mean * mean;
    const Moments m = moments(scenes::alternating(c, a, b));
    CHECK(m.sd == near(static_cast<double>(std::sqrt(squares / 1000.0L)), 3e-16));
}

TEST_CASE("moments: one value has no spread to be told", "[core][moments]")
{
    CHECK_THROWS_AS(moments(std::vector<double>{1.0}), std::invalid_argument);
}
