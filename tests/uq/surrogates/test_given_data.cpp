#include "core/normal.hpp"
#include "tests/uq/latin_scene.hpp"
#include "tests/uq/sensitivity_scenes.hpp"
#include "uq/designs/stream.hpp"
#include "uq/estimates/two_heaps.hpp"
#include "uq/sensitivity/delta_index.hpp"
#include "uq/sensitivity/hsic.hpp"
#include "uq/sensitivity/rank_index.hpp"

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

TEST_CASE("hsic: share and index are those of OpenTURNS 1.20", "[uq][hsic]")
{
    // HSICEstimatorGlobalSensitivity, R2-HSIC, SquaredExponential of the standard deviation,
    // nugget 0; HSICVStat and HSICUStat
    constexpr int n = 64;
    const double share[] = {0.14874222818322108, 0.01937130392791646, 0.06209077630263789},
                 index[] = {0.12049302094252307, -0.01493376490881048, 0.02427059083935697};
    Eigen::MatrixXd u(n, 3);
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            u(i, k) = std::fmod((i + 1) * std::sqrt(k == 2 ? 5.0 : 2.0 + k), 1.0);
    const Eigen::VectorXd y = scenes::ishigami(u);
    for (int k = 0; k < 3; ++k) {
        const Hsic h = hsic(u.col(k), y);
        CHECK(h.share == Approx(share[k]).epsilon(1e-10));
        CHECK(h.index.value == Approx(index[k]).epsilon(1e-10));
        CHECK(h.index.interval.lower >= 0.0);
        CHECK(h.index.interval.upper > h.index.interval.lower);
    }
}

TEST_CASE(
    "hsic: index of two normal variables, and its error, in closed form and by repetition",
    "[uq][hsic]")
{
    // kernels as wide as the variables: E k l = 1 / sqrt(9 - 4 r^2), E k E l = 1/3, and
    // E (E' k)(E' l) = 1 / sqrt(9 - r^2)
    const auto exact = [](double r) {
        return 1.0 / std::sqrt(9.0 - 4.0 * r * r) + 1.0 / 3.0 - 2.0 / std::sqrt(9.0 - r * r);
    };
    constexpr double kShare = 0.5; // squared correlation
    constexpr int kRepetitions = 60;
    const double truth = exact(std::sqrt(kShare)) / exact(1.0);
    Eigen::VectorXd value(kRepetitions), error(kRepetitions);
    int held = 0;
    for (int r = 0; r < kRepetitions; ++r) {
        const Eigen::VectorXd x = normals(150, 1000 + 2 * r), e = normals(150, 1001 + 2 * r);
        const Hsic h = hsic(x, x + e, {.permutations = 19});
        value(r) = h.index.value;
        error(r) = h.index.std_error;
        held += h.index.interval.lower <= truth && truth <= h.index.interval.upper ? 1 : 0;
    }
    const double scatter = std::sqrt((value.array() - value.mean()).square().mean());
    CHECK(value.mean() == Approx(truth).margin(3.0 * scatter / std::sqrt(kRepetitions)));
    CHECK(error.mean() == Approx(scatter).epsilon(0.3)); // chi of 59: 3 sd are 0.28
    CHECK(held >= 51);                                   // binomial(60, 0.95): 99.8 %
}

TEST_CASE("rank index: a worked example, ties, and its ends", "[uq][rank_index]")
{
    // x ascending, ranks of y 2 1 3 5 4: 1 - 3 (1 + 2 + 2 + 1) / (25 - 1)
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(5, 0.0, 1.0);
    Eigen::VectorXd y(5);
    y << 0.2, -1.0, 0.3, 9.0, 2.0;
    CHECK(raw_rank_index(x, y) == Approx(0.25).epsilon(1e-12));
    CHECK(raw_rank_index(x, y.array().exp()) == raw_rank_index(x, y)); // ranks alone count
    // 1 1 2 2: r = 2 2 4 4, l = 4 4 2 2: 1 - 4 x 2 / (2 (0 + 0 + 4 + 4))
    CHECK(raw_rank_index(x.head(4), Eigen::Vector4d(1, 1, 2, 2)) == Approx(0.5));
    const Eigen::VectorXd z = normals(400, 21);
    CHECK(raw_rank_index(z, z.array().square()) > 0.97);        // a law, though no correlation
    CHECK(std::abs(raw_rank_index(z, normals(400, 22))) < 0.1); // sd sqrt(0.4 / n) = 0.03
    CHECK_THROWS_AS(rank_index(z, Eigen::VectorXd::Ones(400)), std::invalid_argument);
    CHECK_THROWS_AS(rank_index(z, z.head(399)), std::invalid_argument);
}

TEST_CASE("rank index: its test has the level that it says where responses are equal",
          "[uq][rank_index]")
{
    // 0 but for a fifth of the samples
    const double bound = core::normal_quantile(0.8);
    int by_chance = 0;
    for (int r = 0; r < 400; ++r) {
        const Eigen::VectorXd x = normals(100, 4000 + 2 * r);
        const Eigen::VectorXd y =
            (normals(100, 4001 + 2 * r).array() > bound).cast<double>().matrix();
        by_chance += independence_p(rank_index(x, y, {.halves = 20}), y) < 0.05 ? 1 : 0;
    }
    CHECK(by_chance >= 7); // binomial(400, 0.05): 7 .. 34 with 99.8 %
    CHECK(by_chance <= 34);
    // two values, one half each: F = 1/2 and 1, E phi^2 = 7/16, E[E(phi | y)^2] = 13/32,
    // E phi = 5/8, E[G (1 - G)] = 1/8: a variance of (7/16 - 13/16 + 25/64) / (1/64) = 1
    const Eigen::VectorXd half = Eigen::VectorXd::LinSpaced(4000, 0.0, 1.0).array().round();
    Estimate e{};
    e.value = 0.01;
    e.n = 10000;
    CHECK(independence_p(e, half) == Approx(core::normal_survival(1.0)).margin(2e-4));
}

TEST_CASE("rank index: of two normal variables, and its error by repetition",
          "[uq][rank_index]")
{
    // corr r: 3 / pi asin((1 + r^2) / 2) - 1/2 (Gaussian copula)
    const double truth = 3.0 / M_PI * std::asin(0.75) - 0.5;
    constexpr int kRepetitions = 60;
    Eigen::VectorXd value(kRepetitions), error(kRepetitions);
    int held = 0, by_chance = 0;
    for (int r = 0; r < kRepetitions; ++r) {
        const Eigen::VectorXd x = normals(200, 2000 + 2 * r), e = normals(200, 2001 + 2 * r);
        const Estimate i = rank_index(x, x + e, {.halves = 60});
        by_chance += independence_p(rank_index(x, e, {.halves = 20}), e) < 0.1 ? 1 : 0;
        value(r) = i.value;
        error(r) = i.std_error;
        held += i.interval.lower <= truth && truth <= i.interval.upper ? 1 : 0;
    }
    const double scatter = std::sqrt((value.array() - value.mean()).square().mean());
    // its bias of few samples is some 1 / n
    CHECK(value.mean() == Approx(truth).margin(3.0 * scatter / std::sqrt(kRepetitions) + 0.01));
    CHECK(error.mean() == Approx(scatter).epsilon(0.35));
    CHECK(held >= 51);     // binomial(60, 0.95): 99.8 %
    CHECK(by_chance >= 1); // binomial(60, 0.1): 1 .. 14 with 99.7 %
    CHECK(by_chance <= 14);
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
