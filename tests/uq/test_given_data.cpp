#include "uq/sensitivity/given_data.hpp"

#include "tests/uq/latin_scene.hpp"
#include "tests/uq/sensitivity_scenes.hpp"
#include "uq/fields/field.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

/// Standard error reported over that seen in 600 studies of a response of the first of two inputs
/// and normal noise from the second.
double error_ratio(double (*effect)(double), double noise)
{
    const int studies = 600, n = 1000;
    double sum = 0.0, squares = 0.0, reported = 0.0;
    for (std::uint64_t k = 0; k < studies; ++k) {
        const Eigen::MatrixXd u = scenes::monte_carlo(n, 2, 500 + k);
        Eigen::VectorXd y = noise * normal_coordinates(u.col(1));
        for (Eigen::Index i = 0; i < n; ++i) y[i] += effect(u(i, 0));
        const Estimate e = *given_data_first_order(u.col(0), y)[0];
        sum += e.value / studies;
        squares += e.value * e.value / studies;
        reported += e.std_error * e.std_error / studies;
    }
    return std::sqrt(reported / (squares - sum * sum));
}

} // namespace

TEST_CASE("given data: Ishigami and g-function within error bars", "[uq][given_data]")
{
    const Eigen::MatrixXd u = scenes::monte_carlo(20000, 3, 1);
    const auto s = given_data_first_order(u, scenes::ishigami(u));
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(s[i]->value - scenes::kIshigamiFirst[i]) < 4.0 * s[i]->std_error);
        CHECK(s[i]->std_error < 0.02);
    }
    const double first[] = {.986711842, .00986711842, .0000986711840};
    const auto g = given_data_first_order(u, scenes::g_function(u, {0, 9, 99}));
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(std::abs(g[i]->value - first[i]) < 4.0 * g[i]->std_error);
}

TEST_CASE(
    "given data: the standard error is that seen in repetitions, the bias is small against "
    "it, the error falls like 1 / sqrt(n)",
    "[uq][given_data]")
{
    const int studies = 1000;
    for (const std::size_t i : {0u, 1u, 2u}) {
        double rms[2] = {0.0, 0.0};
        for (const int size : {0, 1}) {
            double bias = 0.0, reported = 0.0;
            int held = 0;
            for (int k = 0; k < studies; ++k) {
                const Eigen::MatrixXd u = scenes::monte_carlo(
                    size == 0 ? 125 : 500, 3, static_cast<std::uint64_t>(1000 + k));
                const Estimate e = *given_data_first_order(u.col(static_cast<Eigen::Index>(i)),
                                                           scenes::ishigami(u))[0];
                const double off = e.value - scenes::kIshigamiFirst[i];
                bias += off / studies;
                rms[size] += off * off / studies;
                reported += e.std_error * e.std_error / studies;
                held += e.interval.lower <= scenes::kIshigamiFirst[i] &&
                        scenes::kIshigamiFirst[i] <= e.interval.upper;
            }
            INFO("input " << i << " size " << size << " bias " << bias << " rms "
                          << std::sqrt(rms[size]) << " ratio "
                          << std::sqrt(reported / rms[size]) << " held "
                          << held / double(studies));
            CHECK(std::abs(bias) < 0.25 * std::sqrt(rms[size]));
            CHECK(std::sqrt(reported / rms[size]) == Approx(1.0).margin(0.15));
            CHECK(held / double(studies) >
                  (size == 0 ? 0.86 : 0.90)); // uq/sensitivity/given_data.hpp
        }
        CHECK(std::sqrt(rms[0] / rms[1]) == Approx(2.0).epsilon(0.15));
    }
}

TEST_CASE("given data: neighbours share a response, and only that goes into the standard error",
          "[uq][given_data]")
{
    // Index 3/4 with the same square everywhere: without the covariance of neighbours 1.4.
    const auto sides = [](double u) { return u < 0.5 ? -1.0 : 1.0; };
    CHECK(error_ratio(sides, std::sqrt(1.0 / 3.0)) == Approx(1.0).margin(0.12));
    // Index 1/2 from a tenth of the samples: with what all share through the level 1.4.
    const auto ends = [](double u) {
        const double size = std::sqrt(10.0);
        return u < 0.05 ? -size : u > 0.95 ? size : 0.0;
    };
    CHECK(error_ratio(ends, 1.0) == Approx(1.0).margin(0.12));
}

TEST_CASE("given data: all of the variance from one input, none from another",
          "[uq][given_data]")
{
    const Eigen::MatrixXd u = scenes::monte_carlo(2000, 2, 5);
    const auto s = given_data_first_order(u, u.col(0).array().square());
    CHECK(s[0]->value > 0.99);
    CHECK(std::abs(s[1]->value) < 4.0 * s[1]->std_error);
}

TEST_CASE("given data: failed rows are left out and counted, a constant input has no index",
          "[uq][given_data]")
{
    Eigen::MatrixXd u = scenes::monte_carlo(200, 3, 6);
    u.col(2).setConstant(0.5);
    Eigen::VectorXd y = scenes::ishigami(u);
    y[4] = std::numeric_limits<double>::quiet_NaN();
    const auto s = given_data_first_order(u, y);
    CHECK(s[0]->failed == 1);
    CHECK(s[0]->n == 199);
    CHECK_FALSE(s[2].has_value());
    CHECK_THROWS_AS(given_data_first_order(u, Eigen::VectorXd::Ones(200)),
                    std::invalid_argument);
    CHECK_THROWS_AS(given_data_first_order(u.topRows(9), y.tail(9)), std::invalid_argument);
}
