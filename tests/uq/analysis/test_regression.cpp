#include "uq/sensitivity/regression.hpp"

#include "core/interval.hpp"
#include "core/moments.hpp"
#include "tests/uq/latin_scene.hpp"
#include "tests/uq/sensitivity_scenes.hpp"
#include "uq/sensitivity/correlation_measures.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

auto near(double value, double tolerance)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

/// n x d standard normal values.
Eigen::MatrixXd normal_inputs(std::uint64_t sample, Eigen::Index n, Eigen::Index d)
{
    Stream s(41, sample, Purpose::monte_carlo);
    return Eigen::MatrixXd::NullaryExpr(n, d, [&s] { return s.normal(); });
}

/// 3 x1 - 2 x2 + noise of sd 1: variance 14; x3 does nothing.
Eigen::VectorXd linear(const Eigen::MatrixXd& x)
{
    return 3.0 * x.col(0) - 2.0 * x.col(1) + x.col(3);
}

bool holds(const core::Interval& i, double truth)
{
    return i.lower <= truth && truth <= i.upper;
}

} // namespace

TEST_CASE("regression: coefficients of a linear model are a_i s_i / s", "[uq][regression]")
{
    const Eigen::MatrixXd x = normal_inputs(0, 100000, 4);
    const Regression r = *regress(x.leftCols(3), linear(x));
    const double sd = std::sqrt(14.0);
    const double src[] = {3.0 / sd, -2.0 / sd, 0.0};
    // partial: a_i / sqrt(a_i^2 + noise^2)
    const double pcc[] = {3.0 / std::sqrt(10.0), -2.0 / std::sqrt(5.0), 0.0};
    for (std::size_t j = 0; j < 3; ++j) {
        const RegressionCoefficient& c = r.inputs[j];
        CHECK(std::abs(c.standardised.value - src[j]) < 4.0 * c.standardised.std_error);
        CHECK(std::abs(c.partial.value - pcc[j]) < 4.0 * c.partial.std_error);
        CHECK(c.standardised.std_error < 0.004);
    }
    CHECK(r.r2 == near(13.0 / 14.0, 2e-3));
    CHECK(r.rank == 3);
}

TEST_CASE("regression: with one input it is the correlation, on values and ranks",
          "[uq][regression]")
{
    const Eigen::MatrixXd x = normal_inputs(1, 60, 2);
    const Eigen::VectorXd y = x.col(0).array().exp() + x.col(1).array();
    const double p = pearson(x.col(0), y)->value, s = spearman(x.col(0), y)->value;
    const Regression v = *regress(x.col(0), y);
    const Regression k = *regress(x.col(0), y, {.scale = RegressionScale::ranks});
    CHECK(v.inputs[0].standardised.value == near(p, 1e-13));
    CHECK(v.inputs[0].partial.value == near(p, 1e-13));
    CHECK(v.r2 == near(p * p, 1e-12));
    CHECK(k.inputs[0].standardised.value == near(s, 1e-13));
    CHECK(k.inputs[0].partial.value == near(s, 1e-13));
}

TEST_CASE("regression: errors of a partial coefficient are Fisher's with n - 3 less the others",
          "[uq][regression]")
{
    const Eigen::MatrixXd x = normal_inputs(7, 12, 4);
    const RegressionCoefficient c = regress(x.leftCols(3), linear(x))->inputs[0];
    const double r = c.partial.value, z_error = 1.0 / std::sqrt(12.0 - 3.0 - 2.0);
    CHECK(c.partial.std_error == near((1.0 - r * r) * z_error, 1e-14));
    CHECK(c.partial.interval.lower ==
          near(std::tanh(std::atanh(r) - 1.9599639845400545 * z_error), 1e-12));
}

TEST_CASE("regression: ranks see a monotonic response that is not linear whole",
          "[uq][regression]")
{
    const Eigen::MatrixXd x = normal_inputs(2, 500, 1);
    const Eigen::VectorXd y = (3.0 * x.col(0).array()).exp();
    CHECK(regress(x, y)->r2 < 0.5);
    const Regression r = *regress(x, y, {.scale = RegressionScale::ranks});
    CHECK(r.r2 == near(1.0, 1e-13));
    CHECK(r.inputs[0].partial.value == near(1.0, 1e-12));
}

TEST_CASE("regression: correlated inputs are told apart", "[uq][regression]")
{
    Eigen::MatrixXd x = normal_inputs(3, 50000, 4);
    x.col(1) = 0.8 * x.col(0) + 0.6 * x.col(1);
    const Eigen::VectorXd y = x.col(0) + x.col(3);
    const Regression r = *regress(x.leftCols(3), y);
    CHECK(std::abs(r.inputs[1].partial.value) < 4.0 * r.inputs[1].partial.std_error);
    CHECK(pearson(x.col(1), y)->value > 0.5); // seen alone it looks strong
    CHECK(std::abs(r.inputs[0].standardised.value - std::sqrt(0.5)) <
          4.0 * r.inputs[0].standardised.std_error);
}

TEST_CASE("regression: intervals hold the truth as often as they say, asymptotic and bootstrap",
          "[uq][regression][slow]")
{
    const std::size_t bootstrap = GENERATE(0u, 200u);
    const int studies = bootstrap == 0 ? 3000 : 600;
    int first = 0, none = 0, partial = 0;
    for (int k = 0; k < studies; ++k) {
        const Eigen::MatrixXd x = normal_inputs(static_cast<std::uint64_t>(100 + k), 100, 4);
        const Regression r = *regress(x.leftCols(3), linear(x), {.bootstrap = bootstrap});
        first += holds(r.inputs[0].standardised.interval, 3.0 / std::sqrt(14.0));
        none += holds(r.inputs[2].standardised.interval, 0.0);
        partial += holds(r.inputs[1].partial.interval, -2.0 / std::sqrt(5.0));
    }
    const double tolerance =
        3.0 * std::sqrt(0.95 * 0.05 / studies) + 0.015; // asymptotic at 100
    CHECK(std::abs(first / double(studies) - 0.95) < tolerance);
    CHECK(std::abs(none / double(studies) - 0.95) < tolerance);
    CHECK(std::abs(partial / double(studies) - 0.95) < tolerance);
}

TEST_CASE("regression: standard errors of rank coefficients are those seen in repetitions",
          "[uq][regression]")
{
    std::vector<double> src, pcc;
    double src_error = 0.0, pcc_error = 0.0;
    const int studies = 1500;
    for (int k = 0; k < studies; ++k) {
        const Eigen::MatrixXd x = normal_inputs(static_cast<std::uint64_t>(5000 + k), 100, 4);
        const Eigen::VectorXd y = (0.5 * linear(x)).array().exp();
        const auto c = regress(x.leftCols(3), y, {.scale = RegressionScale::ranks})->inputs[0];
        src.push_back(c.standardised.value);
        pcc.push_back(c.partial.value);
        src_error += c.standardised.std_error / studies;
        pcc_error += c.partial.std_error / studies;
    }
    CHECK(src_error / core::moments(src).sd ==
          Approx(1.0).margin(0.25)); // ranks: an approximation
    CHECK(pcc_error / core::moments(pcc).sd == Approx(1.0).margin(0.25));
}

TEST_CASE("regression: the interval of a partial rank coefficient of a strong input holds",
          "[uq][regression]")
{
    // normal pairs beside an input of no effect: 6 / pi asin(r / 2), less than 1e-3 off
    const double r = 0.96, truth = 6.0 / M_PI * std::asin(0.5 * r);
    const int studies = 1000;
    int held = 0;
    for (int k = 0; k < studies; ++k) {
        const Eigen::MatrixXd x = normal_inputs(static_cast<std::uint64_t>(9000 + k), 200, 3);
        const Eigen::VectorXd y = r * x.col(0) + std::sqrt(1.0 - r * r) * x.col(2);
        const auto c = regress(x.leftCols(2), y, {.scale = RegressionScale::ranks})->inputs[0];
        held += holds(c.partial.interval, truth);
    }
    CHECK(held >= 925); // binomial(1000, 0.95): 99.9 %
}

TEST_CASE("regression: collinear and constant inputs are flagged and spoil no other",
          "[uq][regression]")
{
    const Eigen::MatrixXd z = normal_inputs(4, 200, 4);
    const Eigen::VectorXd y = linear(z);
    Eigen::MatrixXd x(200, 5);
    x << z.col(0), z.col(1), z.col(2),
        2.0 * z.col(1) - 3.0 * z.col(2) + Eigen::VectorXd::Ones(200),
        Eigen::VectorXd::Constant(200, 7.0);
    const Regression r = *regress(x, y), clean = *regress(z.leftCols(3), y);
    CHECK(r.rank == 3);
    CHECK(r.r2 == near(clean.r2, 1e-12));
    CHECK(r.inputs[0].identifiable);
    CHECK(r.inputs[0].standardised.value == near(clean.inputs[0].standardised.value, 1e-12));
    CHECK(r.inputs[0].standardised.std_error ==
          near(clean.inputs[0].standardised.std_error, 1e-10));
    CHECK(r.inputs[0].partial.value == near(clean.inputs[0].partial.value, 1e-12));
    for (const std::size_t j : {1u, 2u, 3u, 4u}) {
        CHECK_FALSE(r.inputs[j].identifiable);
        CHECK(std::isfinite(r.inputs[j].standardised.value));
        CHECK(std::isinf(r.inputs[j].standardised.std_error));
        CHECK(r.inputs[j].partial.interval.lower == -1.0);
    }
}

TEST_CASE("regression: failed rows are left out and counted, nothing is asked of a constant "
          "response",
          "[uq][regression]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Eigen::MatrixXd x = normal_inputs(5, 50, 4);
    Eigen::VectorXd y = linear(x), holed = y;
    holed[3] = holed[17] = nan;
    std::vector<Eigen::Index> sound;
    for (Eigen::Index i = 0; i < 50; ++i)
        if (i != 3 && i != 17) sound.push_back(i);
    const Regression a = *regress(x, holed), b = *regress(x(sound, Eigen::all), y(sound));
    CHECK(a.failed == 2);
    CHECK(a.n == 48);
    CHECK(a.inputs[0].standardised.value == b.inputs[0].standardised.value);
    CHECK_FALSE(regress(x, Eigen::VectorXd::Ones(50)).has_value());
    CHECK_THROWS_AS(regress(x.topRows(7), y.head(7)), std::invalid_argument);
    CHECK_THROWS_AS(regress(x, y, {.bootstrap = 5}), std::invalid_argument);
}

TEST_CASE("regression: resamples are keyed: the same seed gives the same interval",
          "[uq][regression]")
{
    const Eigen::MatrixXd x = normal_inputs(6, 50, 4);
    const auto upper = [&](std::uint64_t seed) {
        return regress(x.leftCols(2), linear(x), {.bootstrap = 50, .seed = seed})
            ->inputs[0]
            .standardised.interval.upper;
    };
    CHECK(upper(1) == upper(1));
    CHECK(upper(1) != upper(2));
}
