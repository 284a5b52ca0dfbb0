#include "fragility/fits/observation.hpp"

#include "fragility/curve/limit_states.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace fragility;

TEST_CASE("observation: walls are known as far as one of them reached the limit state or stood",
          "[fragility][observation]")
{
    const std::vector<Observation> walls = {observed(2.0), right_censored(3.0)};
    CHECK(known_to(walls) == 3.0);
    CHECK(known_to({}) == 0.0);
    CHECK(is_known(3.0, 3.0));
    CHECK(is_known(3.0 * (1.0 + 0.9 * kEndsTogether), 3.0));
    CHECK_FALSE(is_known(3.0 * (1.0 + 1.1 * kEndsTogether), 3.0));
}

TEST_CASE("observation: runs that ended together end at the first of their ends",
          "[fragility][observation]")
{
    const double last = 3.0, just_before = last * (1.0 - 0.5 * kEndsTogether);
    CHECK(common_end(std::vector{right_censored(1.0), right_censored(just_before),
                                 right_censored(last)}) == just_before);
    CHECK(common_end(std::vector{right_censored(1.0), observed(just_before),
                                 right_censored(last)}) == last);
    CHECK(common_end({}) == 0.0);
}

TEST_CASE("observation: a drift limit stays one, and limits are counted by their value",
          "[fragility][observation]")
{
    const LimitDisplacement limit{0.011, Reading::observed,
                                  "governed by the code's drift limit"},
        own{0.011, Reading::observed, {}};
    const Observation capped = *observation(limit, 2.0);
    CHECK(capped.lower == 0.022);
    CHECK(capped.upper == 0.022);
    CHECK(capped.capped);
    CHECK_FALSE(observation(own)->capped);
    Observation twice = *observation(limit);
    twice.weight = 2.0;
    const std::vector<Observation> walls = {capped, observed(0.022), twice, capped,
                                            right_censored(0.011)};
    CHECK(caps(walls) == std::vector<Cap>{{0.011, 2.0}, {0.022, 2.0}});
    CHECK(caps({}).empty());
}
