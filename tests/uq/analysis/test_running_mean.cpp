#include "uq/estimates/running_mean.hpp"

#include "tests/uq/latin_scene.hpp"

#include <catch2/catch.hpp>
#include <gsl/gsl_cdf.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();

/// Friction angle of the joints, Table 5 of the paper: normal, mean 31.8, COV 0.20.
std::vector<double> friction(const Eigen::MatrixXd& u)
{
    std::vector<double> y;
    for (const double p : u.col(0)) y.push_back(31.8 + 6.36 * gsl_cdf_ugaussian_Pinv(p));
    return y;
}

/// Standard error of the mean of n standard normal values, one in each of n strata: sqrt(sum of
/// the variances inside the strata) / n.
double error_within_strata(int n)
{
    double sum = 0.0;
    const auto density = [](double z) {
        return std::exp(-0.5 * z * z) / std::sqrt(2.0 * M_PI);
    };
    for (int i = 0; i < n; ++i) {
        const bool first = i == 0, last = i == n - 1;
        const double a = first ? 0.0 : gsl_cdf_ugaussian_Pinv(double(i) / n);
        const double b = last ? 0.0 : gsl_cdf_ugaussian_Pinv(double(i + 1) / n);
        const double fa = first ? 0.0 : density(a), fb = last ? 0.0 : density(b);
        const double mean = n * (fa - fb), square = 1.0 + n * (a * fa - b * fb);
        sum += square - mean * mean;
    }
    return std::sqrt(sum) / n;
}

} // namespace

TEST_CASE("running mean: error and band against the prescribed mean", "[uq][running_mean]")
{
    const std::vector<double> y{3.0, 1.0, 5.0};
    const auto r = running_mean(y, {2.0, 0.5});
    REQUIRE(r.size() == 3);
    CHECK(r[0].error == 0.5);
    CHECK(r[1].error == 0.0);
    CHECK(r[2].mean == 3.0);
    CHECK(r[2].error == 0.5);
    CHECK(r[2].band == Approx(1.959963984540054 * 0.25 / std::sqrt(3.0)).epsilon(1e-14));
    const auto absolute = running_mean(y, {2.0, 0.5}, false);
    CHECK(absolute[0].error == 1.0);
    CHECK(absolute[2].band == Approx(2.0 * r[2].band).epsilon(1e-15));
}

TEST_CASE("running mean: a mean below zero is as far off above as below", "[uq][running_mean]")
{
    CHECK(running_mean(std::vector<double>{-1.0}, {-2.0, 1.0})[0].error == 0.5);
    CHECK(running_mean(std::vector<double>{-1.0}, {-2.0, 1.0})[0].band > 0.0);
}

TEST_CASE(
    "running mean: independent samples leave the band as often as it says; against the final "
    "mean too",
    "[uq][running_mean]")
{
    const int studies = 2000;
    int prescribed = 0, final = 0;
    for (int k = 0; k < studies; ++k) {
        const auto y = friction(scenes::monte_carlo(50, 1, static_cast<std::uint64_t>(k)));
        const auto a = running_mean(y, {31.8, 6.36})[19], b = running_mean(y)[19];
        prescribed += std::abs(a.error) > a.band;
        final += std::abs(b.error) > b.band;
    }
    const double error = std::sqrt(0.95 * 0.05 / studies);
    CHECK(std::abs(prescribed / double(studies) - 0.05) < 3.0 * error);
    CHECK(std::abs(final / double(studies) - 0.05) < 3.0 * error);
}

TEST_CASE("running mean: a Latin hypercube of 50 ends with the error that is left inside its "
          "strata, a tenth of that of independent samples",
          "[uq][running_mean]")
{
    const double exact = 0.20 * error_within_strata(50); // COV 0.20
    double squares = 0.0;
    int as_the_paper = 0; // Fig. 10: below 0.2 %
    const int studies = 2000;
    for (int k = 0; k < studies; ++k) {
        const auto u = scenes::latin_hypercube(50, 1, static_cast<std::uint64_t>(k));
        const RunningMean last = running_mean(friction(u), {31.8, 6.36}).back();
        squares += last.error * last.error;
        as_the_paper += std::abs(last.error) < 0.002;
        CHECK(std::abs(last.error) < last.band);
    }
    CHECK(std::sqrt(squares / studies) == Approx(exact).epsilon(0.15)); // two strata have tails
    CHECK(exact < 0.1 * 0.20 / std::sqrt(50.0));
    CHECK(as_the_paper > studies / 2);
}

TEST_CASE("running mean: against the final mean it ends at zero, and so does its band",
          "[uq][running_mean]")
{
    const auto r = running_mean(friction(scenes::monte_carlo(50, 1, 9)));
    CHECK(std::abs(r.back().error) < 1e-14);
    CHECK(r.back().band == 0.0);
    CHECK(r[48].band > 0.0);
}

TEST_CASE("running mean: failed samples count as samples, not as values", "[uq][running_mean]")
{
    const std::vector<double> y{kNan, 2.0, kNan, 4.0};
    const auto r = running_mean(y, {3.0, 1.0});
    REQUIRE(r.size() == 3);
    CHECK(r[0].samples == 2);
    CHECK(r[0].sound == 1);
    CHECK(r[1].mean == 2.0);
    CHECK(r[2].samples == 4);
    CHECK(r[2].sound == 2);
    CHECK(r[2].mean == 3.0);
}

TEST_CASE("running mean: what has no meaning is refused", "[uq][running_mean]")
{
    const std::vector<double> y{1.0, 2.0}, none{kNan};
    CHECK_THROWS_AS(running_mean(y, {0.0, 1.0}), std::invalid_argument);
    CHECK_NOTHROW(running_mean(y, {0.0, 1.0}, false));
    CHECK_THROWS_AS(running_mean(y, {1.0, -1.0}), std::invalid_argument);
    CHECK_THROWS_AS(running_mean(none, {1.0, 1.0}), std::invalid_argument);
}
