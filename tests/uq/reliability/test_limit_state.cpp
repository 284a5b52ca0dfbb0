#include "tests/uq/reliability/reliability_problems.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

TEST_CASE("limit state: passed at or below, or at or above, its threshold in physical units",
          "[uq][limit_state]")
{
    LimitState s = problems::limit_state(
        1, [](const Eigen::VectorXd& x) { return x(0); },
        [](const Eigen::MatrixXd& u) { return Eigen::MatrixXd(10.0 + 2.0 * u.array()); });
    s.threshold = 12.0;
    Ledger ledger;
    const Eigen::MatrixXd u{{0.0}, {1.0}, {3.0}};
    CHECK(limit_values(s, u, ledger) == Eigen::Vector3d(-2.0, 0.0, 4.0));
    s.passing = Passing::at_or_above;
    CHECK(limit_values(s, u, ledger) == Eigen::Vector3d(2.0, 0.0, -4.0));
    CHECK(ledger.evaluations == 6);
    CHECK(ledger.batches == 2);
}

TEST_CASE("limit state: failed samples are kept with number, parameters and reason",
          "[uq][limit_state]")
{
    const LimitState s = problems::failing(problems::rp22().limit,
                                           [](const Eigen::VectorXd& x) { return x(0) > 1.5; });
    Ledger ledger;
    const Eigen::MatrixXd u{{0.0, 0.0}, {2.0, 7.0}};
    CHECK_FALSE(std::isnan(limit_values(s, u, ledger)(0)));
    CHECK(std::isnan(limit_values(s, u, ledger)(1)));
    REQUIRE(ledger.failed.size() == 2);
    CHECK(ledger.failed[1].id == 3);
    CHECK(ledger.failed[1].x == Eigen::Vector2d(2.0, 7.0));
    CHECK(ledger.failed[1].reason == "no convergence");
}

TEST_CASE("limit state: what is missing or out of range is refused", "[uq][limit_state]")
{
    const LimitState good = problems::rp22().limit;
    CHECK_NOTHROW(check(good));
    LimitState s = good;
    s.model = {};
    CHECK_THROWS_AS(check(s), std::invalid_argument);
    s = good;
    s.dimension = 0;
    CHECK_THROWS_AS(check(s), std::invalid_argument);
    s = good;
    s.response = -1;
    CHECK_THROWS_AS(check(s), std::invalid_argument);
    s = good;
    s.threshold = std::nan("");
    CHECK_THROWS_AS(check(s), std::invalid_argument);
}
