#include "fragility/curve/curve_reading.hpp"

#include "tests/fragility/curve_scenes.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <stdexcept>

using namespace fragility;
using scenes::OwnedCurve;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kRounding = 4e-16; // relative, of a few operations

auto near(double value) { return Approx(value).epsilon(kRounding).margin(0.0); }

} // namespace

TEST_CASE("curve reading: the peak is the first of repeated maxima",
          "[fragility][curve_reading]")
{
    const Peak p = peak(OwnedCurve{{0, 0}, {1, 10}, {2, 6}, {3, 10}, {4, 10}});
    CHECK(p.force == 10.0);
    CHECK(p.displacement == 1.0);
    CHECK_FALSE(p.at_end);
}

TEST_CASE("curve reading: a curve that rises to its last point says so",
          "[fragility][curve_reading]")
{
    CHECK(peak(scenes::straight()).at_end);
    CHECK(peak(OwnedCurve{{2, 6}}).at_end);
    CHECK_FALSE(peak(OwnedCurve{{0, 6}}).at_end);
    CHECK_FALSE(peak(scenes::elastic_plastic()).at_end);
}

TEST_CASE("curve reading: the secant of an elastic branch is its stiffness at any share",
          "[fragility][curve_reading]")
{
    const double share = GENERATE(0.15, 0.30, 0.60, 1.0);
    CHECK(secant_stiffness(scenes::elastic_plastic(), share).value() == near(5.0));
    CHECK(secant_stiffness(scenes::triangle(), share).value() == near(10.0));
}

TEST_CASE("curve reading: the secant is taken at 30 % of the peak unless told otherwise",
          "[fragility][curve_reading]")
{
    const OwnedCurve softening{{0, 0}, {1, 3}, {3, 6}, {9, 10}};
    CHECK(secant_stiffness(softening).value() == near(3.0));
    CHECK(secant_stiffness(softening, 0.6).value() == near(2.0));
}

TEST_CASE("curve reading: a curve that starts late is led there from the origin",
          "[fragility][curve_reading]")
{
    const OwnedCurve late{{0.5, 10}, {1, 9}, {5, 1}};
    CHECK(secant_stiffness(late).value() == near(20.0));
    CHECK(area(late, 0.5) == near(2.5));
    CHECK(area(late, 0.25) == near(0.625));
    CHECK(first_reaching(late, 0.0).value() == 0.0);
    CHECK(first_reaching(OwnedCurve{{1, -4}, {2, 4}}, -1.0).value() == 0.0);
}

TEST_CASE("curve reading: without an elastic branch there is no secant stiffness",
          "[fragility][curve_reading]")
{
    CHECK_FALSE(secant_stiffness(scenes::descending()));
    CHECK_FALSE(secant_stiffness(scenes::negative()));
    CHECK_FALSE(secant_stiffness(OwnedCurve{{0, 0}, {0, 5}, {1, 10}}));
    CHECK_FALSE(secant_stiffness(OwnedCurve{{0, 0}, {1, 0}}));
    CHECK_FALSE(secant_stiffness(OwnedCurve{{0, 0}, {1e-320, 10}})); // the quotient overflows
}

TEST_CASE("curve reading: a force that is never reached has no displacement",
          "[fragility][curve_reading]")
{
    CHECK_FALSE(first_reaching(scenes::triangle(), 10.1));
    CHECK(first_reaching(scenes::triangle(), 10.0).value() == 1.0);
    CHECK(first_reaching(scenes::triangle(), 2.5).value() == near(0.25));
    CHECK(first_reaching(scenes::descending(), 3.0).value() == 0.0);
}

TEST_CASE("curve reading: the area is exact on straight pieces and across a step",
          "[fragility][curve_reading]")
{
    CHECK(area(scenes::triangle(), 0.0) == 0.0);
    CHECK(area(scenes::triangle(), 1.4) == near(8.6));
    CHECK(area(scenes::triangle(), 3.0) == near(15.0));
    const OwnedCurve step{{0, 0}, {1, 10}, {1, 5}, {2, 5}};
    CHECK(area(step, 1.0) == near(5.0));
    CHECK(area(step, 2.0) == near(10.0));
    CHECK(area(scenes::descending(), 1.0) == near(9.5));
    CHECK_THROWS_AS(area(step, 2.1), std::invalid_argument);
    CHECK_THROWS_AS(area(step, -0.1), std::invalid_argument);
    CHECK_THROWS_AS(area(step, kNan), std::invalid_argument);
}

TEST_CASE("curve reading: the drop of a triangle is where the straight branch has it",
          "[fragility][curve_reading]")
{
    const double share = GENERATE(0.05, 0.5, 0.8, 0.95);
    const Crossing crossing = GENERATE(Crossing::first, Crossing::last);
    const LimitDisplacement x = drop_after_peak(scenes::triangle(), share, crossing);
    CHECK(x.reading == Reading::observed);
    CHECK(x.displacement == near(1.0 + 2.0 * (1.0 - share)));
    CHECK(x.reason.empty());
}

TEST_CASE("curve reading: first and last crossing of a jerky curve are apart",
          "[fragility][curve_reading]")
{
    CHECK(drop_after_peak(scenes::jerky()).displacement == near(1.0 + 2.0 / 3.0));
    const LimitDisplacement last = drop_after_peak(scenes::jerky(), 0.8, Crossing::last);
    CHECK(last.reading == Reading::observed);
    CHECK(last.displacement == near(3.0 + 1.0 / 3.0));
}

TEST_CASE("curve reading: a drop lies where a peak that is wrong by its error puts it",
          "[fragility][curve]")
{
    using fragility::drop_range;
    const std::vector<double> x{0.0, 1.0, 2.0}, f{0.0, 100.0, 0.0};
    const auto steady = drop_range({x, f}, 0.8, Crossing::first, 0.01);
    CHECK(steady.earliest.displacement == near(1.192));
    CHECK(steady.latest.displacement == near(1.208));
    const std::vector<double> at{0.0, 1.0, 2.0, 3.0, 4.0}, touch{0.0, 100.0, 79.6, 90.0, 0.0};
    const auto touching = drop_range({at, touch}, 0.8, Crossing::first, 0.01);
    CHECK(touching.earliest.displacement == near(1.0 + 19.2 / 20.4));
    CHECK(touching.latest.displacement == near(3.0 + 10.8 / 90.0));
    const std::vector<double> stops{0.0, 1.0, 2.0}, above{0.0, 100.0, 79.5};
    const auto beyond = drop_range({stops, above}, 0.8, Crossing::first, 0.01);
    CHECK(is_observed(beyond.earliest));
    CHECK(is_censored(beyond.latest));
    const auto whole = drop_range({x, f}, 0.8, Crossing::first, 2.0); // nothing is known
    CHECK(whole.earliest.displacement == near(1.0));
    CHECK(whole.latest.displacement == near(2.0));
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(is_defined(drop_range({x, f}, 0.8, Crossing::first, unknown).earliest));
    CHECK_FALSE(is_defined(drop_range({x, f}, 0.8, Crossing::first, unknown).latest));
}

TEST_CASE("curve reading: a drop that recovers by the end is a first crossing but no last one",
          "[fragility][curve_reading]")
{
    const OwnedCurve recovers{{0, 0}, {1, 10}, {2, 7}, {3, 9}};
    CHECK(drop_after_peak(recovers).reading == Reading::observed);
    const LimitDisplacement last = drop_after_peak(recovers, 0.8, Crossing::last);
    CHECK(last.reading == Reading::censored);
    CHECK(last.displacement == 3.0);
    CHECK(last.reason == "the force has recovered where the curve ends");
}

TEST_CASE("curve reading: touching the level is a drop", "[fragility][curve_reading]")
{
    CHECK(drop_after_peak(OwnedCurve{{0, 0}, {1, 10}, {2, 8}, {3, 10}}).displacement == 2.0);
    const OwnedCurve ends_there{{0, 0}, {1, 10}, {2, 8}};
    CHECK(drop_after_peak(ends_there, 0.8, Crossing::last).reading == Reading::observed);
    CHECK(drop_after_peak(ends_there, 0.8, Crossing::last).displacement == 2.0);
}

TEST_CASE("curve reading: a drop between two equal maxima counts", "[fragility][curve_reading]")
{
    const OwnedCurve twice{{0, 0}, {1, 10}, {2, 6}, {3, 10}, {4, 10}, {5, 0}};
    CHECK(drop_after_peak(twice).displacement == near(1.5));
    CHECK(drop_after_peak(twice, 0.8, Crossing::last).displacement == near(4.2));
}

TEST_CASE("curve reading: a step drops at its own displacement", "[fragility][curve_reading]")
{
    CHECK(drop_after_peak(OwnedCurve{{0, 0}, {1, 10}, {1, 5}, {2, 5}}).displacement == 1.0);
}

TEST_CASE("curve reading: what has not dropped is censored where the curve ends",
          "[fragility][curve_reading]")
{
    const Crossing crossing = GENERATE(Crossing::first, Crossing::last);
    const LimitDisplacement flat = drop_after_peak(scenes::elastic_plastic(), 0.8, crossing);
    CHECK(flat.reading == Reading::censored);
    CHECK(flat.displacement == 10.0);
    CHECK(flat.reason == "the push ended before the force fell that far");
    const LimitDisplacement rising = drop_after_peak(scenes::straight(), 0.8, crossing);
    CHECK(rising.reading == Reading::censored);
    CHECK(rising.displacement == 3.0);
    CHECK(rising.reason == "the force still rises where the curve ends");
}

TEST_CASE("curve reading: a single point is a peak that has not dropped",
          "[fragility][curve_reading]")
{
    const OwnedCurve point{{2, 6}};
    CHECK(peak(point).force == 6.0);
    CHECK(secant_stiffness(point).value() == near(3.0));
    CHECK(drop_after_peak(point).reading == Reading::censored);
    CHECK(drop_after_peak(point).displacement == 2.0);
}

TEST_CASE("curve reading: a curve that descends from its start drops as any other",
          "[fragility][curve_reading]")
{
    const LimitDisplacement x = drop_after_peak(scenes::descending());
    CHECK(x.reading == Reading::observed);
    CHECK(x.displacement == near(1.5));
}

TEST_CASE("curve reading: without a positive force there is no drop to define",
          "[fragility][curve_reading]")
{
    const LimitDisplacement x = drop_after_peak(scenes::negative());
    CHECK(x.reading == Reading::not_defined);
    CHECK(x.displacement == 0.0);
    CHECK(x.reason == "the force is nowhere positive");
}

TEST_CASE("curve reading: units scale out", "[fragility][curve_reading]")
{
    const double length = 1.0 / 1024.0, newton = 2048.0; // powers of two: the same digits
    OwnedCurve c = scenes::jerky();
    const double stiffness = secant_stiffness(c).value();
    const double energy = area(c, 3.3);
    const double drop = drop_after_peak(c).displacement;
    for (double& d : c.displacement) d *= length;
    for (double& f : c.force) f *= newton;
    CHECK(secant_stiffness(c).value() == stiffness * newton / length);
    CHECK(area(c, 3.3 * length) == energy * newton * length);
    CHECK(drop_after_peak(c).displacement == drop * length);
}

TEST_CASE("curve reading: a bad curve is refused with the point that breaks it",
          "[fragility][curve_reading]")
{
    using Catch::Matchers::Contains;
    CHECK_THROWS_WITH(peak(OwnedCurve{}), Contains("no points"));
    CHECK_THROWS_WITH(peak(OwnedCurve{{0, 0}, {1, kNan}}), Contains("point 2: force"));
    CHECK_THROWS_WITH(peak(OwnedCurve{{0, 0}, {1, kInf}}), Contains("point 2: force"));
    CHECK_THROWS_WITH(peak(OwnedCurve{{0, 0}, {kNan, 1}}), Contains("point 2: displacement"));
    CHECK_THROWS_WITH(peak(OwnedCurve{{0, 0}, {2, 1}, {1, 1}}),
                      Contains("point 3: displacement dec"));
    CHECK_THROWS_WITH(peak(OwnedCurve{{-1, 0}, {1, 1}}),
                      Contains("point 1: displacement is neg"));
    const std::vector<double> two = {0.0, 1.0}, three = {0.0, 1.0, 2.0};
    CHECK_THROWS_WITH(peak(Curve{two, three}), Contains("one force for each"));
}

TEST_CASE("curve reading: every function refuses a bad curve", "[fragility][curve_reading]")
{
    const OwnedCurve bad{{0, 0}, {1, kNan}};
    CHECK_THROWS_AS(check(bad), std::invalid_argument);
    CHECK_THROWS_AS(peak(bad), std::invalid_argument);
    CHECK_THROWS_AS(first_reaching(bad, 1.0), std::invalid_argument);
    CHECK_THROWS_AS(area(bad, 0.5), std::invalid_argument);
    CHECK_THROWS_AS(secant_stiffness(bad), std::invalid_argument);
    CHECK_THROWS_AS(drop_after_peak(bad), std::invalid_argument);
}

TEST_CASE("curve reading: shares outside their range are refused", "[fragility][curve_reading]")
{
    CHECK_THROWS_AS(secant_stiffness(scenes::triangle(), 0.0), std::invalid_argument);
    CHECK_THROWS_AS(secant_stiffness(scenes::triangle(), 1.1), std::invalid_argument);
    CHECK_THROWS_AS(secant_stiffness(scenes::triangle(), kNan), std::invalid_argument);
    CHECK_THROWS_AS(drop_after_peak(scenes::triangle(), -0.1), std::invalid_argument);
    CHECK_THROWS_AS(drop_after_peak(scenes::triangle(), 1.0), std::invalid_argument);
    CHECK_THROWS_AS(drop_after_peak(scenes::triangle(), kNan), std::invalid_argument);
}
