#include "uq/sensitivity/sobol_indices.hpp"

#include "tests/uq/latin_scene.hpp"
#include "tests/uq/sensitivity_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <gsl/gsl_cdf.h>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

Eigen::MatrixXd design(int n, int d, std::uint64_t seed)
{
    return pick_freeze(scenes::monte_carlo(n, d, 2 * seed),
                       scenes::monte_carlo(n, d, 2 * seed + 1));
}

void check_within(const Estimate& e, double truth)
{
    CHECK(std::abs(e.value - truth) < 4.0 * e.std_error);
}

} // namespace

TEST_CASE("sobol indices: Ishigami within error bars", "[uq][sobol_indices]")
{
    const SobolIndices s = sobol_indices(scenes::ishigami(design(20000, 3, 1)), 3);
    for (std::size_t i = 0; i < 3; ++i) {
        check_within(s.inputs[i].first, scenes::kIshigamiFirst[i]);
        check_within(s.inputs[i].total, scenes::kIshigamiTotal[i]);
        CHECK(s.inputs[i].first.std_error < 0.02);
    }
    CHECK(s.variance == Approx(13.8445879407193).epsilon(0.03));
}

TEST_CASE("sobol indices: g-functions within error bars", "[uq][sobol_indices]")
{
    const struct {
        std::vector<double> a, first, total;
    } cases[] = {{{0, 9, 99},
                  {.986711842, .00986711842, .0000986711840},
                  {.990033881, .0131565964, .000132000118}},
                 {{0, 1, 4.5, 9, 99, 99, 99, 99},
                  {.716192169, .179048042, .0236757742, .00716192169, .000071619217,
                   .000071619217, .000071619217, .000071619217},
                  {.787144127, .242198193, .0343169102, .0104603871, .000104949052,
                   .000104949052, .000104949052, .000104949052}}};
    for (const auto& c : cases) {
        const int d = static_cast<int>(c.a.size());
        const auto s = sobol_indices(scenes::g_function(design(20000, d, 2), c.a), d);
        for (std::size_t i = 0; i < c.a.size(); ++i) {
            check_within(s.inputs[i].first, c.first[i]);
            check_within(s.inputs[i].total, c.total[i]);
        }
    }
}

TEST_CASE("sobol indices: a sum of normal variables has the shares a^2 s^2 / variance",
          "[uq][sobol_indices]")
{
    const Eigen::MatrixXd u = design(20000, 3, 3);
    const Eigen::MatrixXd z = u.unaryExpr([](double p) { return gsl_cdf_ugaussian_Pinv(p); });
    const Eigen::VectorXd y = 1000.0 + (3.0 * z.col(0) - 2.0 * z.col(1) + z.col(2)).array();
    const SobolIndices s = sobol_indices(y, 3);
    const double share[] = {9.0 / 14.0, 4.0 / 14.0, 1.0 / 14.0};
    for (std::size_t i = 0; i < 3; ++i) {
        check_within(s.inputs[i].first, share[i]);
        check_within(s.inputs[i].total, share[i]);
        CHECK(s.inputs[i].first.std_error < 0.02); // the large mean does no harm
    }
}

TEST_CASE("sobol indices: the error falls like 1 / sqrt(n), the standard error is true and the "
          "interval holds",
          "[uq][sobol_indices]")
{
    const int studies = 400;
    double rms[2] = {0.0, 0.0};
    int held = 0;
    double reported = 0.0;
    for (int k = 0; k < studies; ++k)
        for (const int size : {0, 1}) {
            const auto seed = static_cast<std::uint64_t>(1000 + k);
            const auto y = scenes::ishigami(design(size == 0 ? 250 : 1000, 3, seed));
            const Estimate e = sobol_indices(y, 3).inputs[0].first;
            rms[size] += std::pow(e.value - scenes::kIshigamiFirst[0], 2) / studies;
            if (size == 0) continue;
            reported += e.std_error * e.std_error / studies;
            held += e.interval.lower <= scenes::kIshigamiFirst[0] &&
                    scenes::kIshigamiFirst[0] <= e.interval.upper;
        }
    CHECK(std::sqrt(rms[0] / rms[1]) == Approx(2.0).epsilon(0.15));
    CHECK(std::sqrt(reported / rms[1]) == Approx(1.0).epsilon(0.12));
    CHECK(std::abs(held / double(studies) - 0.95) < 3.0 * std::sqrt(0.95 * 0.05 / studies));
}

TEST_CASE("sobol indices: of three rows by hand", "[uq][sobol_indices]")
{
    // A, B, AB; less the common mean 2: a = -1 2 -1, b = 1 -2 1, ab = 0 3 -2; variance 2
    const Eigen::VectorXd y{{1, 4, 1, 3, 0, 3, 2, 5, 0}};
    const SobolIndices s = sobol_indices(y, 1);
    CHECK(s.inputs[0].first.value == Approx(-1.0 / 3.0).epsilon(1e-15));
    CHECK(s.inputs[0].total.value == Approx(0.25).epsilon(1e-15));
    CHECK(s.variance == Approx(2.4).epsilon(1e-15)); // of the six of A and B, over 5
    const SobolIndices moved = sobol_indices((y.array() + 1e6).matrix(), 1);
    CHECK(moved.inputs[0].first.value == Approx(-1.0 / 3.0).epsilon(1e-9));
}

TEST_CASE("sobol indices: the standard error is the jackknife's", "[uq][sobol_indices]")
{
    const Eigen::Index n = 300;
    const Eigen::VectorXd y = scenes::ishigami(design(n, 3, 8));
    const SobolIndices all = sobol_indices(y, 3);
    double first = 0.0, total = 0.0;
    for (Eigen::Index k = 0; k < n; ++k) {
        Eigen::VectorXd without = y;
        without[k] = std::numeric_limits<double>::quiet_NaN();
        const SobolIndex s = sobol_indices(without, 3).inputs[0];
        first += std::pow(s.first.value - all.inputs[0].first.value, 2);
        total += std::pow(s.total.value - all.inputs[0].total.value, 2);
    }
    CHECK(all.inputs[0].first.std_error == Approx(std::sqrt(first)).epsilon(0.02));
    CHECK(all.inputs[0].total.std_error == Approx(std::sqrt(total)).epsilon(0.02));
}

TEST_CASE("sobol indices: pick and freeze exchanges one column", "[uq][sobol_indices]")
{
    const Eigen::MatrixXd a = scenes::monte_carlo(4, 3, 1), b = scenes::monte_carlo(4, 3, 2);
    const Eigen::MatrixXd x = pick_freeze(a, b);
    REQUIRE(x.rows() == 20);
    CHECK(x.topRows(4) == a);
    CHECK(x.middleRows(4, 4) == b);
    CHECK(x.middleRows(12, 4).col(1) == b.col(1));
    CHECK(x.middleRows(12, 4).col(0) == a.col(0));
    CHECK(x.middleRows(12, 4).col(2) == a.col(2));
}

TEST_CASE("sobol indices: failed rows are left out of the index they belong to and counted",
          "[uq][sobol_indices]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Eigen::Index n = 5000;
    Eigen::VectorXd y = scenes::ishigami(design(n, 3, 4));
    y[7] = nan;         // A: gone from all
    y[n + 8] = nan;     // B: gone from all
    y[3 * n + 9] = nan; // second input only
    const SobolIndices s = sobol_indices(y, 3);
    CHECK(s.inputs[0].first.failed == 2);
    CHECK(s.inputs[1].total.failed == 3);
    CHECK(s.inputs[2].first.failed == 2);
    CHECK(s.inputs[1].first.n == static_cast<std::size_t>(n) - 3);
    for (std::size_t i = 0; i < 3; ++i)
        check_within(s.inputs[i].total, scenes::kIshigamiTotal[i]);
}

TEST_CASE("sobol indices: what has none is refused", "[uq][sobol_indices]")
{
    CHECK_THROWS_AS(sobol_indices(Eigen::VectorXd::Ones(11), 3), std::invalid_argument);
    CHECK_THROWS_AS(sobol_indices(Eigen::VectorXd::Ones(50), 3), std::invalid_argument);
    CHECK_THROWS_AS(sobol_indices(Eigen::VectorXd(0), 3), std::invalid_argument);
    CHECK_THROWS_AS(pick_freeze(Eigen::MatrixXd(3, 2), Eigen::MatrixXd(4, 2)),
                    std::invalid_argument);
}
