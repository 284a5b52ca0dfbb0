#include "uq/sensitivity/correlation_measures.hpp"

#include "core/interval.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

auto near(double value, double tolerance)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

/// n pairs of standard normal values of correlation rho.
Eigen::MatrixXd pairs(std::uint64_t sample, Eigen::Index n, double rho)
{
    Stream s(31, sample, Purpose::monte_carlo);
    Eigen::MatrixXd x(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
        x(i, 0) = s.normal();
        x(i, 1) = rho * x(i, 0) + std::sqrt(1.0 - rho * rho) * s.normal();
    }
    return x;
}

} // namespace

TEST_CASE("correlation: ranks, equal values share theirs", "[uq][correlation_measures]")
{
    const Eigen::VectorXd y{{3.0, 1.0, 2.0, 1.0, 7.0}};
    CHECK(ranks(y) == Eigen::VectorXd{{4.0, 1.5, 3.0, 1.5, 5.0}});
    CHECK(ranks(Eigen::VectorXd::Ones(3)) == Eigen::VectorXd{{2.0, 2.0, 2.0}});
}

TEST_CASE("correlation: Pearson and Spearman of small samples by hand",
          "[uq][correlation_measures]")
{
    const Eigen::VectorXd x{{1.0, 2.0, 3.0, 4.0, 5.0}}, y{{2.0, 1.0, 4.0, 3.0, 5.0}};
    CHECK(pearson(x, y)->value == near(0.8, 1e-15));
    CHECK(spearman(x, y)->value == near(0.8, 1e-15));
    CHECK(pearson(x, x)->value == near(1.0, 1e-15));
    CHECK(pearson(x, x)->interval.lower == near(1.0, 1e-13));
    CHECK(pearson(x, -2.0 * x)->value == near(-1.0, 1e-15));
    const Eigen::VectorXd cube = x.array().cube();
    CHECK(spearman(x, cube)->value == near(1.0, 1e-15)); // monotonic
    CHECK(pearson(x, cube)->value < 0.97);
}

TEST_CASE("correlation: error and interval are those of atanh r with n - 3, Spearman's wider",
          "[uq][correlation_measures]")
{
    const Eigen::VectorXd x{{1.0, 2.0, 3.0, 4.0, 5.0}}, y{{2.0, 1.0, 4.0, 3.0, 5.0}};
    const double z = std::atanh(0.8), factor = 1.9599639845400545;
    const auto agrees = [&](const Estimate& e, double z_error) {
        CHECK(e.std_error == near(0.36 * z_error, 1e-14));
        CHECK(e.interval.lower == near(std::tanh(z - factor * z_error), 1e-13));
        CHECK(e.interval.upper == near(std::tanh(z + factor * z_error), 1e-13));
    };
    agrees(*pearson(x, y), std::sqrt(1.0 / 2.0));           // Fisher 1921
    agrees(*spearman(x, y), std::sqrt((1.0 + 0.32) / 2.0)); // Bonett and Wright 2000
}

TEST_CASE("correlation: of normal pairs, Spearman tends to 6 / pi asin(rho / 2)",
          "[uq][correlation_measures]")
{
    const double rho = GENERATE(-0.9, 0.0, 0.5);
    const auto xy = pairs(0, 100000, rho);
    const Estimate p = *pearson(xy.col(0), xy.col(1)), s = *spearman(xy.col(0), xy.col(1));
    CHECK(std::abs(p.value - rho) < 4.0 * p.std_error);
    CHECK(std::abs(s.value - 6.0 / M_PI * std::asin(0.5 * rho)) < 4.0 * s.std_error);
}

TEST_CASE("correlation: intervals hold the truth as often as they say, at 50 samples",
          "[uq][correlation_measures]")
{
    const double rho = GENERATE(0.0, 0.7);
    const double truth = 6.0 / M_PI * std::asin(0.5 * rho);
    int p = 0, s = 0;
    const int studies = 4000;
    for (int k = 0; k < studies; ++k) {
        const auto xy = pairs(static_cast<std::uint64_t>(k + 1), 50, rho);
        const core::Interval a = pearson(xy.col(0), xy.col(1))->interval;
        const core::Interval b = spearman(xy.col(0), xy.col(1))->interval;
        p += a.lower <= rho && rho <= a.upper;
        s += b.lower <= truth && truth <= b.upper;
    }
    const double error = std::sqrt(0.95 * 0.05 / studies);
    CHECK(std::abs(p / double(studies) - 0.95) < 3.0 * error);
    CHECK(std::abs(s / double(studies) - 0.95) < 0.015); // approximation of the variance
}

TEST_CASE("correlation: failed rows are left out and counted; without variation there is none",
          "[uq][correlation_measures]")
{
    const Eigen::VectorXd x{{1.0, 2.0, 9.0, 3.0, 4.0, kNan, 5.0}};
    const Eigen::VectorXd y{{2.0, 1.0, kNan, 4.0, 3.0, 0.0, 5.0}};
    const auto r = pearson(x, y);
    CHECK(r->value == near(0.8, 1e-15));
    CHECK(r->n == 5);
    CHECK(r->failed == 2);
    CHECK(spearman(x, y)->failed == 2);
    CHECK_FALSE(pearson(Eigen::VectorXd::Ones(7), y).has_value());
    CHECK_FALSE(spearman(x, Eigen::VectorXd::Ones(7)).has_value());
    CHECK_THROWS_AS(pearson(x.head(3), y.head(3)), std::invalid_argument);
    CHECK_THROWS_AS(pearson(x, y.head(3)), std::invalid_argument);
    CHECK_THROWS_AS(pearson(Eigen::VectorXd::Constant(7, INFINITY), y), std::invalid_argument);
}
