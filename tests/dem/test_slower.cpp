#include "dem/solver/slower.hpp"

#include "dem/solver/push.hpp"

#include <catch2/catch.hpp>

#include <limits>

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
