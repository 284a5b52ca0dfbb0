#include "core/binomial.hpp"
#include "core/interval.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace core;

namespace {

using enum BinomialInterval;
/// To the ten decimals given.
auto near(double value) { return Approx(value).epsilon(0.0).margin(6e-11); }

} // namespace

TEST_CASE("binomial: intervals as computed with R", "[core][binomial]")
{
    const auto check = [](Interval i, double lower, double upper) {
        CHECK(i.lower == near(lower));
        CHECK(i.upper == near(upper));
    };
    check(binomial_interval(clopper_pearson, 3, 50), 0.0125485878, 0.1654819466);
    check(binomial_interval(wilson, 3, 50), 0.0206149703, 0.1621709169);
    check(binomial_interval(clopper_pearson, 13, 40), 0.18572896676, 0.4912948755);
    check(binomial_interval(wilson, 13, 40), 0.2008450223, 0.4798225381);
    check(binomial_interval(clopper_pearson, 0, 50), 0.0, 0.0711217365);
    check(binomial_interval(wilson, 0, 50), 0.0, 0.0713475991);
    // qbeta(c(.025, .975), 3.5, 47.5) and (13.5, 27.5)
    check(binomial_interval(jeffreys, 3, 50), 0.0171866490712, 0.1515325630277);
    check(binomial_interval(jeffreys, 13, 40), 0.195950964121, 0.478360673488);
}

TEST_CASE("binomial: exchanging hits and misses mirrors the interval", "[core][binomial]")
{
    const BinomialInterval kind = GENERATE(wilson, clopper_pearson, jeffreys);
    const double k = GENERATE(0.0, 1.0, 7.0, 20.0);
    const Interval a = binomial_interval(kind, k, 20, 0.9);
    const Interval b = binomial_interval(kind, 20 - k, 20, 0.9);
    CHECK(a.lower == Approx(1.0 - b.upper).margin(1e-14));
    CHECK(a.upper == Approx(1.0 - b.lower).margin(1e-14));
    CHECK(a.lower <= k / 20.0);
    CHECK(a.upper >= k / 20.0);
}

TEST_CASE("binomial: Clopper-Pearson never covers less than it says, Wilson about that",
          "[core][binomial]")
{
    double wilson_mean = 0.0;
    for (int step = 1; step < 100; ++step) {
        const double p = 0.01 * step;
        const boost::math::binomial law(30, p);
        double exact = 0.0;
        for (int k = 0; k <= 30; ++k) {
            const Interval c = binomial_interval(clopper_pearson, k, 30);
            const Interval w = binomial_interval(wilson, k, 30);
            if (c.lower <= p && p <= c.upper) exact += pdf(law, k);
            if (w.lower <= p && p <= w.upper) wilson_mean += pdf(law, k) / 99.0;
        }
        CHECK(exact >= 0.95);
    }
    CHECK(wilson_mean == Approx(0.95).margin(0.01));
}

TEST_CASE("binomial: counts that cannot be are refused", "[core][binomial]")
{
    CHECK_THROWS_AS(binomial_interval(wilson, 3, 2), std::invalid_argument);
    CHECK_THROWS_AS(binomial_interval(wilson, -1, 2), std::invalid_argument);
    CHECK_THROWS_AS(binomial_interval(wilson, 0, 0), std::invalid_argument);
    CHECK_THROWS_AS(binomial_interval(wilson, std::nan(""), 2), std::invalid_argument);
    CHECK_THROWS_AS(binomial_interval(wilson, 1, 2, 1.0), std::invalid_argument);
}
