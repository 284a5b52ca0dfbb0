#include "fragility/curve/bilinear.hpp"

#include "tests/fragility/curve_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace fragility;
using scenes::OwnedCurve;

namespace {

auto near(double value) { return Approx(value).epsilon(1e-14).margin(0.0); }

void check_failed(const Bilinear& b, BilinearOutcome why)
{
    CHECK(b.outcome == why);
    CHECK_FALSE(reason(b.outcome).empty());
    CHECK(b.stiffness == 0.0);
    CHECK(b.yield_displacement == 0.0);
    CHECK(b.yield_force == 0.0);
    CHECK(b.ultimate_displacement == 0.0);
    CHECK(b.ductility == 0.0);
}

} // namespace

TEST_CASE("bilinear: an elastic-perfectly plastic curve is its own bilinear",
          "[fragility][bilinear]")
{
    const double share = GENERATE(0.3, kBilinearShare, kBilinearShareDatabase, 1.0);
    const double ultimate = GENERATE(2.0, 7.3, 10.0);
    const Bilinear b = equal_energy_bilinear(scenes::elastic_plastic(), ultimate, share);
    CHECK(b.outcome == BilinearOutcome::found);
    CHECK(reason(b.outcome).empty());
    CHECK(b.stiffness == near(5.0));
    CHECK(b.yield_displacement == near(1.0));
    CHECK(b.yield_force == near(5.0));
    CHECK(b.ultimate_displacement == ultimate);
    CHECK(b.ductility == near(ultimate));
}

TEST_CASE("bilinear: a triangle yields at the smaller root of the energy equation",
          "[fragility][bilinear]")
{
    // up to 1.4: E = 8.6, k = 10, d_y^2 - 2.8 d_y + 1.72 = 0
    const Bilinear b = equal_energy_bilinear(scenes::triangle(), 1.4);
    CHECK(b.yield_displacement == near(1.4 - std::sqrt(0.24)));
    CHECK(b.yield_force == near(14.0 - std::sqrt(24.0)));
    CHECK(b.ductility == near(1.4 / (1.4 - std::sqrt(0.24))));
}

TEST_CASE("bilinear: it passes through 60 % of the peak and encloses the area of the curve",
          "[fragility][bilinear]")
{
    const OwnedCurve c{{0, 0}, {0.4, 4}, {1, 6}, {2, 9}, {3, 10}, {5, 7.5}, {6, 8.5}, {9, 8}};
    const double ultimate = GENERATE(4.6, 6.0, 9.0);
    const Bilinear b = equal_energy_bilinear(c, ultimate);
    REQUIRE(b.outcome == BilinearOutcome::found);
    CHECK(b.stiffness == near(6.0));
    CHECK(b.yield_force * (ultimate - 0.5 * b.yield_displacement) == near(area(c, ultimate)));
    CHECK(equal_energy_bilinear(c, ultimate, 0.9).stiffness == near(4.5));
}

TEST_CASE("bilinear: a straight curve yields where it ends", "[fragility][bilinear]")
{
    // d_u^2 - 2 E / k is 0 up to rounding, either sign; its root is of the order 1e-8
    for (double slope = 0.1; slope < 30.0; slope *= 1.37) {
        const OwnedCurve c{{0, 0}, {0.7, 0.7 * slope}, {1.9, 1.9 * slope}, {3.3, 3.3 * slope}};
        const Bilinear b = equal_energy_bilinear(c, 3.3);
        CHECK(b.outcome == BilinearOutcome::found);
        CHECK(b.yield_displacement == Approx(3.3).epsilon(1e-7).margin(0.0));
        CHECK(b.yield_displacement <= 3.3);
        CHECK(b.ductility >= 1.0);
    }
}

TEST_CASE("bilinear: a single point is a straight curve from the origin",
          "[fragility][bilinear]")
{
    const Bilinear b = equal_energy_bilinear(OwnedCurve{{2, 6}}, 2.0);
    CHECK(b.outcome == BilinearOutcome::found);
    CHECK(b.stiffness == near(3.0));
    CHECK(b.yield_force == Approx(6.0).epsilon(1e-7).margin(0.0));
}

TEST_CASE("bilinear: what has none is named", "[fragility][bilinear]")
{
    SECTION("no positive force")
    {
        check_failed(equal_energy_bilinear(scenes::negative(), 2.0),
                     BilinearOutcome::no_positive_force);
    }
    SECTION("the force is there without displacement")
    {
        check_failed(equal_energy_bilinear(scenes::descending(), 1.5),
                     BilinearOutcome::no_elastic_branch);
        check_failed(equal_energy_bilinear(OwnedCurve{{0, 6}}, 0.0),
                     BilinearOutcome::no_elastic_branch);
    }
    SECTION("the ultimate displacement comes before 60 % of the peak")
    {
        check_failed(equal_energy_bilinear(scenes::triangle(), 0.59),
                     BilinearOutcome::ultimate_before_share);
        CHECK(equal_energy_bilinear(scenes::triangle(), 0.61).outcome ==
              BilinearOutcome::found);
    }
    SECTION("no energy")
    {
        const OwnedCurve dips{{0, 0}, {1, -10}, {2, -10}, {3, 1}, {4, 0.5}};
        check_failed(equal_energy_bilinear(dips, 4.0), BilinearOutcome::no_positive_area);
    }
    SECTION("a curve that stiffens and breaks has no real root")
    {
        const OwnedCurve stiffens{{0, 0}, {1, 0.6}, {1.01, 1.0}, {1.02, 0.79}};
        check_failed(equal_energy_bilinear(stiffens, 1.02), BilinearOutcome::no_real_root);
    }
}

TEST_CASE("bilinear: an ultimate displacement outside the curve is refused",
          "[fragility][bilinear]")
{
    CHECK_THROWS_AS(equal_energy_bilinear(scenes::triangle(), 3.1), std::invalid_argument);
    CHECK_THROWS_AS(equal_energy_bilinear(scenes::triangle(), -1.0), std::invalid_argument);
    CHECK_THROWS_AS(equal_energy_bilinear(scenes::triangle(), std::nan("")),
                    std::invalid_argument);
    CHECK_THROWS_AS(equal_energy_bilinear(scenes::triangle(), 1.0, 0.0), std::invalid_argument);
}
