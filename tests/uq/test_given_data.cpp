#include "tests/uq/latin_scene.hpp"
#include "uq/designs/stream.hpp"
#include "uq/estimates/two_heaps.hpp"
#include "uq/sensitivity/delta_index.hpp"
#include "uq/sensitivity/hsic.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace uq;

namespace {

Eigen::VectorXd normals(int n, std::uint64_t seed)
{
    Stream s(seed, 0, Purpose::monte_carlo);
    Eigen::VectorXd v(n);
    for (double& x : v) x = s.normal();
    return v;
}

/// delta of x in y = x + noise, both standard normal: 1/2 E |N(0, 2) - N(x, 1)|, by quadrature.
double exact_delta()
{
    const auto density = [](double z, double variance) {
        return std::exp(-0.5 * z * z / variance) / std::sqrt(2.0 * M_PI * variance);
    };
    double delta = 0.0;
    constexpr double kStep = 0.02;
    for (double x = -6.0; x <= 6.0; x += kStep)
        for (double y = -9.0; y <= 9.0; y += kStep)
            delta += 0.5 * kStep * kStep * density(x, 1.0) *
                     std::abs(density(y, 2.0) - density(y - x, 1.0));
    return delta;
}

} // namespace

TEST_CASE("delta index: sum of two normal variables", "[uq][delta_index]")
{
    const Eigen::VectorXd x = normals(400, 1), y = x + normals(400, 2);
    const Estimate e = delta_index(x, y, {.resamples = 40});
    CHECK(e.value == Approx(exact_delta()).margin(0.06));
    CHECK(e.interval.lower < e.value);
    CHECK(e.value < e.interval.upper);
    // monotone maps of the input leave it as it is, to the bit
    CHECK(raw_delta(x.array().exp(), y) == raw_delta(x, y));
}

TEST_CASE("delta index: small without dependence, large with a law", "[uq][delta_index]")
{
    const Eigen::VectorXd x = normals(200, 3), y = normals(200, 4);
    CHECK(delta_index(x, y, {.resamples = 40}).value < 0.12);
    // no correlation, but a law: four classes of x, two and two with the same y, give 1/2 less
    // what the kernels blur
    CHECK(raw_delta(x, x.array().square()) == Approx(0.5).margin(0.05));
    CHECK_THROWS_AS(delta_index(x, Eigen::VectorXd::Ones(200)), std::invalid_argument);
    CHECK_THROWS_AS(delta_index(x, y.head(199)), std::invalid_argument);
}

TEST_CASE("hsic: its test has the level that it says, and sees what correlation does not",
          "[uq][hsic]")
{
    int rejected = 0;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Hsic h = hsic(normals(30, 100 + 2 * seed), normals(30, 101 + 2 * seed),
                            {.permutations = 99, .seed = seed});
        rejected += h.p_value <= 0.10 ? 1 : 0;
    }
    CHECK(rejected >= 2); // binomial(100, 0.1): 2 .. 20 with 99.8 %
    CHECK(rejected <= 20);
    const Eigen::VectorXd x = normals(60, 7);
    CHECK(hsic(x, x.array().square()).p_value == Approx(1.0 / 500.0));
    CHECK(hsic(x, x).share == Approx(1.0).epsilon(1e-12));
    CHECK_THROWS_AS(hsic(x, Eigen::VectorXd::Ones(60)), std::invalid_argument);
}

TEST_CASE("two heaps: found where there are, and seldom where there is one", "[uq][two_heaps]")
{
    Eigen::VectorXd y = normals(80, 5);
    y.head(40).array() += 6.0;
    CHECK(one_heap_p_value(std::span(y.data(), 80)) < 0.02);
    int found = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Eigen::VectorXd one = normals(50, 300 + seed);
        found += one_heap_p_value(std::span(one.data(), 50), 99, seed) < 0.05 ? 1 : 0;
    }
    CHECK(found <= 6); // binomial(40, 0.05): at most 6 with 99.7 %; the test is conservative
    CHECK_THROWS_AS(one_heap_p_value(std::vector<double>(9, 1.0)), std::invalid_argument);
}
