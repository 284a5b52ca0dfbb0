#include "uq/reliability/simulation/control_variate.hpp"

#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;
using Eigen::VectorXd;

namespace {

/// Normal values of unit variance and mean 1 (expensive), 2, 3 ...; correlation with the
/// expensive one as given; non-linear parts of nobody's. Sizes n.
NestedValues normal_values(std::uint64_t seed, const std::vector<double>& rho,
                           const std::vector<Eigen::Index>& n)
{
    NestedValues y;
    for (const Eigen::Index size : n) y.emplace_back(size);
    for (Eigen::Index k = 0; k < n.back(); ++k) {
        Stream random(seed, static_cast<std::uint64_t>(k), Purpose::monte_carlo);
        const double z = random.normal();
        for (std::size_t i = 0; i < n.size(); ++i) {
            const double own = i == 0 ? 0.0 : random.normal();
            const double r = i == 0 ? 1.0 : rho[i - 1];
            if (k < n[i])
                y[i](k) = 1.0 + static_cast<double>(i) + r * z + std::sqrt(1 - r * r) * own;
        }
    }
    return y;
}

struct Repeated {
    double mean = 0.0, variance = 0.0, reported = 0.0, coverage = 0.0;
};

Repeated repeat(const std::vector<double>& rho, const std::vector<Eigen::Index>& n, int times)
{
    Repeated r;
    double square = 0.0;
    for (int k = 0; k < times; ++k) {
        const Estimate e =
            controlled_mean(normal_values(static_cast<std::uint64_t>(k), rho, n)).estimate;
        r.mean += e.value / times;
        square += e.value * e.value;
        r.reported += e.std_error * e.std_error / times;
        r.coverage += (e.interval.lower <= 1.0 && 1.0 <= e.interval.upper ? 1.0 : 0.0) / times;
    }
    r.variance = (square - times * r.mean * r.mean) / (times - 1);
    return r;
}

} // namespace

TEST_CASE("control variate: an expensive value linear in the cheap one has the mean of all "
          "cheap ones",
          "[uq][control_variate]")
{
    NestedValues y = normal_values(1, {0.5}, {10, 200});
    y[0] = 2.0 + 3.0 * y[1].head(10).array();
    const ControlledMean m = controlled_mean(y);
    CHECK(m.coefficient(0) == Approx(3.0).epsilon(1e-13));
    CHECK(m.correlation(0) == Approx(1.0).epsilon(1e-13));
    CHECK(m.estimate.value == Approx(2.0 + 3.0 * y[1].mean()).epsilon(1e-13));
    // Only the doubt about the mean of the 200 is left.
    const double sd = std::sqrt((y[1].array() - y[1].mean()).square().sum() / 199.0);
    CHECK(m.estimate.std_error == Approx(3.0 * sd / std::sqrt(200.0)).epsilon(0.15));
}

TEST_CASE("control variate: variance falls to (1 - rho^2) / n_0 + rho^2 / n_1",
          "[uq][control_variate]")
{
    const double rho = GENERATE(0.0, 0.6, 0.95, -0.9);
    const Repeated r = repeat({rho}, {100, 2000}, 600);
    const double expected = (1.0 - rho * rho) / 100.0 + rho * rho / 2000.0;
    CHECK(std::abs(r.mean - 1.0) < 2.5 * std::sqrt(r.variance / 600.0));
    CHECK(r.variance == Approx(expected).epsilon(0.15)); // sd of a variance of 600: 0.058
    CHECK(r.reported == Approx(r.variance).epsilon(0.15));
}

TEST_CASE("control variate: the standard error counts the estimated coefficient",
          "[uq][control_variate]")
{
    // With 10 expensive samples the coefficient is poor: known, the variance would be 0.0190 +
    // 0.0004.
    const Repeated r = repeat({0.9}, {10, 2000}, 2000);
    CHECK(r.variance > 0.021);
    CHECK(r.reported == Approx(r.variance).epsilon(0.25));
    CHECK(r.reported > r.variance);
    CHECK(r.coverage > 0.935);
    CHECK(std::abs(r.mean - 1.0) < 2.5 * std::sqrt(r.variance / 2000.0));
}

TEST_CASE("control variate: a chain of cheap models, each with more samples",
          "[uq][control_variate]")
{
    const Repeated r = repeat({0.95, 0.7}, {50, 500, 10000}, 600);
    // eq. 3.6 for unit variances: sum of (1/n_(i-1) - 1/n_i) (1 - rho_i^2) and 1/n_k
    const double expected = (1.0 / 50 - 1.0 / 500) * (1 - 0.9025) +
                            (1.0 / 500 - 1.0 / 10000) * (1 - 0.49) + 1.0 / 10000;
    CHECK(r.variance == Approx(expected).epsilon(0.2));
    CHECK(r.reported == Approx(r.variance).epsilon(0.2));
    CHECK(std::abs(r.mean - 1.0) < 2.5 * std::sqrt(r.variance / 600.0));
    CHECK(r.coverage > 0.925);
}

TEST_CASE("control variate: no cheap model is the plain mean and its standard error",
          "[uq][control_variate]")
{
    const NestedValues y{normal_values(3, {}, {40})[0]};
    const ControlledMean m = controlled_mean(y);
    CHECK(m.estimate.value == Approx(y[0].mean()).epsilon(1e-13));
    CHECK(m.estimate.std_error == Approx(m.plain_std_error).epsilon(1e-12));
}

TEST_CASE("control variate: a cheap model that is constant is no help and no harm",
          "[uq][control_variate]")
{
    NestedValues y = normal_values(3, {0.5}, {40, 80});
    y[1].setConstant(7.0);
    const ControlledMean m = controlled_mean(y);
    CHECK(m.coefficient(0) == 0.0);
    CHECK(m.correlation(0) == 0.0);
    CHECK(m.estimate.value == Approx(y[0].mean()).epsilon(1e-13));
}

TEST_CASE("control variate: input out of range is refused", "[uq][control_variate]")
{
    const VectorXd few = VectorXd::Ones(2), some = VectorXd::Ones(5);
    CHECK_THROWS_AS(controlled_mean({}), std::invalid_argument);
    CHECK_THROWS_AS(controlled_mean({few, some}), std::invalid_argument);
    CHECK_THROWS_AS(controlled_mean({some, few}), std::invalid_argument);
    CHECK_THROWS_AS(controlled_mean({VectorXd::Constant(4, std::nan("")), some}),
                    std::invalid_argument);
    CHECK_THROWS_AS(controlled_mean({some, some}, 1.0), std::invalid_argument);
}
