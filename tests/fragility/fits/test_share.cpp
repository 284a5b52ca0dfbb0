#include "fragility/fits/share.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace fragility;

namespace {

using enum core::BinomialInterval;
/// To the ten decimals given.
auto near(double value) { return Approx(value).epsilon(0.0).margin(6e-11); }

} // namespace

TEST_CASE("share: walls without a result widen the interval to what they could have been",
          "[fragility][share]")
{
    const Share s = share(3, 47, 3);
    CHECK(s.value == near(3.0 / 47.0));
    CHECK(s.interval.lower == near(0.0206149703)); // of 3 of 50
    CHECK(s.interval.upper == core::binomial_interval(wilson, 6, 50).upper);
    CHECK(s.interval.lower < core::binomial_interval(wilson, 3, 47).lower);
    CHECK(s.interval.upper > core::binomial_interval(wilson, 3, 47).upper);
    const Share clean = share(3, 50);
    CHECK(clean.interval.lower == core::binomial_interval(wilson, 3, 50).lower);
    CHECK(clean.interval.upper == core::binomial_interval(wilson, 3, 50).upper);
}

TEST_CASE("share: walls that are not decided widen the interval to both sides",
          "[fragility][share]")
{
    const Share s = share(10, 47, 3, wilson, 0.95, {.of_this = 4, .of_other = 7});
    CHECK(s.value == near(10.0 / 47.0));
    CHECK(s.interval.lower == core::binomial_interval(wilson, 6, 50).lower);
    CHECK(s.interval.upper == core::binomial_interval(wilson, 20, 50).upper);
}

TEST_CASE("share: with no result at all the share is anything", "[fragility][share]")
{
    const Share s = share(0, 0, 12);
    CHECK(s.interval.lower == 0.0);
    CHECK(s.interval.upper == 1.0);
    CHECK(s.value == 0.0);
}

TEST_CASE("share: counts that cannot be are refused", "[fragility][share]")
{
    CHECK_THROWS_AS(share(1, 2, -1), std::invalid_argument);
    CHECK_THROWS_AS(share(1, 0, 3), std::invalid_argument);
    CHECK_THROWS_AS(share(-1, 2), std::invalid_argument);
    CHECK_THROWS_AS(share(1, 2, 0, wilson, 0.95, {.of_this = 2}), std::invalid_argument);
    CHECK_THROWS_AS(share(1, 2, 0, wilson, 0.95, {.of_other = 2}), std::invalid_argument);
}
