#include "dem/solver/slower.hpp"

#include "dem/solver/push.hpp"
#include "dem/solver/solver_error.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <vector>

TEST_CASE("slower: twice two times slower is four times, and once is the same", "[dem][slower]")
{
    dem::SolverOptions o;
    o.accuracy = 0.02;
    o.unbalance_limit = 0.004;
    CHECK(dem::slower(dem::slower(o, 2.0), 2.0) == dem::slower(o, 4.0));
    const dem::SolverOptions s = dem::slower(o, 4.0);
    CHECK(s.most_slowdowns == 0); // its own error is what is asked for
    o.most_slowdowns = 0;
    CHECK(dem::slower(o, 1.0) == o);
    CHECK(s.accuracy == 0.005);
    CHECK(s.steps_per_mm == 4.0 * o.steps_per_mm);
    CHECK(s.unbalance_limit == o.unbalance_limit); // a share of the accuracy
    CHECK(s.most_steps == 4 * o.most_steps);
    o.most_steps = 1'000'000'000'000'000'000;
    CHECK(dem::slower(o, 4.0).most_steps == o.most_steps); // not beyond what a number holds
}

TEST_CASE("slower: an accuracy is more than nothing and at most a half", "[dem][slower]")
{
    dem::SolverOptions o;
    for (const double good : {1e-6, 0.01, 0.5}) {
        o.accuracy = good;
        CHECK_NOTHROW(dem::check(dem::PushPlan{}, o));
    }
    for (const double bad : {0.0, -0.01, 0.51, std::numeric_limits<double>::quiet_NaN()}) {
        o.accuracy = bad;
        CHECK_THROWS_WITH(dem::check(dem::PushPlan{}, o),
                          Catch::Contains("the accuracy must lie in (0, 0.5]"));
    }
}

namespace {

/// A force that rises to 100 N over 10 mm and stays, while damping takes 2 N.
std::vector<dem::CurvePoint> dragged()
{
    std::vector<dem::CurvePoint> curve(21);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        curve[i].displacement = 1e-3 * static_cast<double>(i);
        curve[i].force = curve[i].base_shear = i < 10 ? 10.0 * static_cast<double>(i) : 99.0;
        curve[i].energy.damping = 2.0 * curve[i].displacement;
    }
    curve[10].force = curve[10].base_shear = 100.0;
    return curve;
}

} // namespace

TEST_CASE(
    "solver error: what damping takes at the peak counts 10/3, of local damping a quarter",
    "[dem][solver_error]")
{
    const std::vector<dem::CurvePoint> curve = dragged();
    CHECK(dem::force_error(curve, dem::Damping::combined) == Approx(10.0 / 3.0 * 0.02));
    CHECK(dem::force_error(curve, dem::Damping::local) == Approx(0.25 * 0.02));
    CHECK(dem::force_error({}, dem::Damping::combined) == 0.0);
}

TEST_CASE("solver error: a gap between top and base counts by half, before the factor",
          "[dem][solver_error]")
{
    std::vector<dem::CurvePoint> curve = dragged();
    curve[10].base_shear = 97.0; // the point is the mean of both
    CHECK(dem::force_error(curve, dem::Damping::combined) == Approx(10.0 / 3.0 * 0.05));
}

TEST_CASE(
    "solver error: energy that one swing takes at the peak counts, that of a crack does not",
    "[dem][solver_error]")
{
    std::vector<dem::CurvePoint> curve = dragged();
    for (std::size_t i = 10; i < curve.size(); ++i) curve[i].energy.kinetic = 8e-3; // 8 N
    CHECK(dem::force_error(curve, dem::Damping::combined) == Approx(0.10));
    for (std::size_t i = 10; i < curve.size(); ++i) curve[i].energy.fracture = 1e-6;
    CHECK(dem::force_error(curve, dem::Damping::combined) == Approx(10.0 / 3.0 * 0.02));
}
