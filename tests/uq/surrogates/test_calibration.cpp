#include "uq/inference/calibration.hpp"

#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using Eigen::VectorXd;

constexpr std::size_t kLevels = 4; ///< with tests; one more has none
constexpr int kRepeats = 4;        ///< tests of a level

/// ln of a force: grows with the level, depends on two inputs, more on the second one at higher
/// levels.
uq::ModelAnswers force(const VectorXd& z)
{
    constexpr auto n = static_cast<Eigen::Index>(kLevels) + 1;
    uq::ModelAnswers a{VectorXd(n), VectorXd::Zero(n)};
    for (Eigen::Index i = 0; i < n; ++i)
        a.mean(i) = 3.0 + 0.3 * static_cast<double>(i) + 0.15 * z(0) +
                    0.06 * static_cast<double>(i) * z(1);
    return a;
}

uq::CalibrationProblem problem(bool discrepancy)
{
    uq::CalibrationProblem p;
    p.inputs = 2;
    p.quantity.assign(kLevels + 1, 0);
    p.model = force;
    p.discrepancy = discrepancy;
    return p;
}

constexpr uq::CalibrationOptions kFew{.metropolis = {.warm_up = 1000, .draws = 1000},
                                      .longer = 0};

/// The world of one repetition: truth, tests of it, and one further test of each level.
struct World {
    VectorXd z;
    std::vector<uq::MeasuredAnswer> tests;
    VectorXd further;
};

/// A scale drawn from its prior: Student's t of four degrees of freedom, either sign.
double scale(uq::Stream& random)
{
    const double normal = random.normal();
    double squares = 0.0;
    for (int i = 0; i < 4; ++i) squares += std::pow(random.normal(), 2);
    return 0.25 * std::abs(normal) / std::sqrt(squares / 4.0);
}

/// @param biases of the levels: what the model does not know. Empty: those of the prior, and so
/// is the scatter of repeats, which is 5 % else
World world(std::uint64_t repetition, const VectorXd& biases)
{
    uq::Stream random(77, repetition, uq::Purpose::monte_carlo);
    const bool prior = biases.size() == 0;
    World w{VectorXd(2), {}, VectorXd::Zero(kLevels + 1)};
    for (double& v : w.z) v = random.normal();
    const double tau = prior ? scale(random) : 0.0, s = prior ? scale(random) : 0.05;
    w.further = force(w.z).mean;
    if (!prior) w.further += biases;
    for (std::size_t i = 0; i <= kLevels; ++i) {
        double& level = w.further(static_cast<Eigen::Index>(i));
        level += tau * random.normal();
        for (int j = 0; j < kRepeats && i < kLevels; ++j)
            w.tests.push_back({i, level + s * random.normal()});
        level += s * random.normal();
    }
    return w;
}

/// Whether a value lies within the middle 90 % of draws.
bool holds(VectorXd draws, double value)
{
    std::ranges::sort(draws);
    const Eigen::Index n = draws.size();
    return value >= draws(n / 20) && value <= draws(n - 1 - n / 20);
}

struct Shares {
    double first = 0.0, second = 0.0, repeat = 0.0, new_level = 0.0; ///< that hold the truth
};

Shares coverage(int repetitions, bool discrepancy, const VectorXd& biases = {})
{
    Shares shares;
    const double one = 1.0 / repetitions;
    for (int r = 0; r < repetitions; ++r) {
        const World w = world(static_cast<std::uint64_t>(r), biases);
        uq::CalibrationProblem p = problem(discrepancy);
        p.tests = w.tests;
        uq::CalibrationOptions o = kFew;
        o.metropolis.seed = static_cast<std::uint64_t>(r);
        const auto points = uq::calibration_points(p, uq::calibrate(p, o), 1000);
        const Eigen::MatrixXd y = uq::further_tests(p, points, o.metropolis.seed);
        VectorXd a(1000), b(1000);
        for (Eigen::Index k = 0; k < 1000; ++k) {
            a(k) = points[static_cast<std::size_t>(k)].z(0);
            b(k) = points[static_cast<std::size_t>(k)].z(1);
        }
        shares.first += one * holds(a, w.z(0));
        shares.second += one * holds(b, w.z(1));
        shares.repeat += one * holds(y.col(1), w.further(1));
        shares.new_level += one * holds(y.col(kLevels), w.further(kLevels));
    }
    return shares;
}

} // namespace

TEST_CASE("calibration: the likelihood is that of a normal vector with one discrepancy for "
          "each answer",
          "[uq][calibration]")
{
    uq::CalibrationProblem p = problem(true);
    p.own = VectorXd::Constant(kLevels + 1, 0.01);
    p.model = [](const VectorXd& z) {
        uq::ModelAnswers a = force(z);
        a.variance.setConstant(0.02);
        return a;
    };
    p.tests = {{0, 3.1}, {0, 2.9}, {0, 3.3, false, 0.2}, {2, 3.5}};
    const uq::CalibrationPoint at{VectorXd::Constant(2, 0.5), VectorXd::Constant(1, 0.3),
                                  VectorXd::Constant(1, 0.1)};
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(4, 4);
    c.topLeftCorner(3, 3).setConstant(0.09 + 0.02);
    c(3, 3) = 0.09 + 0.02;
    c.diagonal().array() += 0.01 + 0.01;
    c(2, 2) += 0.04;
    VectorXd r(4);
    const VectorXd m = force(at.z).mean;
    r << 3.1 - m(0), 2.9 - m(0), 3.3 - m(0), 3.5 - m(2);
    const double exact = -0.5 * r.dot(c.inverse() * r) - 0.5 * std::log(c.determinant()) -
                         2.0 * std::log(2.0 * std::numbers::pi);
    CHECK(uq::log_likelihood(p, at) == Approx(exact).epsilon(1e-12));
}

TEST_CASE(
    "calibration: one test without a repeat keeps its likelihood however small the scatter",
    "[uq][calibration]")
{
    uq::CalibrationProblem p = problem(true);
    p.tests = {{0, 3.4}};
    for (const double s : {1e-3, 1e-6, 1e-9, 1e-10, 1e-13}) { // of repeats; tau alone is left
        const uq::CalibrationPoint at{VectorXd::Zero(2), VectorXd::Constant(1, 0.3),
                                      VectorXd::Constant(1, s)};
        INFO(s);
        const double variance = 0.09 + s * s;
        CHECK(uq::log_likelihood(p, at) ==
              Approx(-0.5 * (0.16 / variance + std::log(2.0 * std::numbers::pi * variance)))
                  .epsilon(1e-12));
    }
    // a chain cannot fall into a hole that rounding makes
    const uq::CalibrationPosterior posterior = uq::calibrate(p);
    CHECK(uq::has_converged(posterior));
    for (const uq::Chain& chain : posterior.chains) CHECK(chain.draws.minCoeff() > -6.0);
}

TEST_CASE("calibration: a bound counts by the chance that the test is larger",
          "[uq][calibration]")
{
    uq::CalibrationProblem p = problem(true);
    const uq::CalibrationPoint at{VectorXd::Zero(2), VectorXd::Constant(1, 0.3),
                                  VectorXd::Constant(1, 0.4)};
    // y ~ N(3, 0.5^2); 3.5 is one standard deviation above
    p.tests = {{0, 3.5, true}};
    CHECK(std::exp(uq::log_likelihood(p, at)) == Approx(0.158655253931457).epsilon(1e-12));
    p.tests = {{0, 3.5, true}, {0, -50.0, true}}; // the second says nothing: by quadrature
    CHECK(std::exp(uq::log_likelihood(p, at)) == Approx(0.158655253931457).epsilon(1e-9));
    p.tests = {{0, 60.0, true}}; // as good as impossible, but a number
    CHECK(uq::log_likelihood(p, at) == Approx(-0.5 * 114.0 * 114.0).epsilon(1e-3));
}

TEST_CASE("calibration: without tests of weight, the posterior is the prior and its evidence "
          "that of the bound",
          "[uq][calibration]")
{
    uq::CalibrationProblem p = problem(true);
    p.tests = {{0, -50.0, true}}; // always true
    const uq::CalibrationPosterior posterior = uq::calibrate(p);
    CHECK(uq::has_converged(posterior));
    CHECK(posterior.evidence.log_value == Approx(0.0).margin(0.02));
    const auto points = uq::calibration_points(p, posterior, 4000);
    double z2 = 0.0;
    std::vector<double> taus;
    for (const uq::CalibrationPoint& at : points) {
        z2 += at.z(0) * at.z(0) / 4000.0;
        taus.push_back(at.tau(0) / p.prior_scale);
    }
    std::ranges::sort(taus);
    CHECK(z2 == Approx(1.0).epsilon(0.12));
    CHECK(taus[2000] == Approx(0.740697).epsilon(0.06)); // 75 and 97.5 % of Student's t
    CHECK(taus[3800] == Approx(2.776445).epsilon(0.12));
}

TEST_CASE("calibration: intervals of 90 % hold the truth in 85 to 95 % of 200 repetitions",
          "[uq][calibration][repeats]")
{
    const Shares s = coverage(200, true); // 0.9 +- 0.02
    INFO(s.first << ' ' << s.second << ' ' << s.repeat << ' ' << s.new_level);
    for (const double share : {s.first, s.second, s.repeat, s.new_level}) {
        CHECK(share >= 0.85);
        CHECK(share <= 0.95);
    }
}

TEST_CASE("calibration: a wrong model predicts honestly with its discrepancy, and not without",
          "[uq][calibration][repeats]")
{
    VectorXd biases(kLevels + 1);
    biases << 0.3, 0.3, -0.3, 0.3, -0.3;
    const Shares with = coverage(50, true, biases), without = coverage(50, false, biases);
    INFO(with.repeat << ' ' << with.new_level << "; " << without.first << ' '
                     << without.new_level);
    CHECK(with.repeat >= 0.85);
    CHECK(with.new_level >= 0.85);
    CHECK(with.first >= 0.85);
    CHECK(without.first < 0.6);
}

TEST_CASE("calibration: the same seed gives the same posterior; nonsense is refused",
          "[uq][calibration]")
{
    uq::CalibrationProblem p = problem(true);
    p.tests = {{0, 3.1}, {1, 3.4}, {1, 3.2}};
    const auto a = uq::calibrate(p, kFew), b = uq::calibrate(p, kFew);
    CHECK(a.chains.back().draws == b.chains.back().draws);
    CHECK(a.evidence.log_value == b.evidence.log_value);
    const auto points = uq::calibration_points(p, a, 50);
    CHECK(uq::further_tests(p, points, 1) == uq::further_tests(p, points, 1));
    CHECK(uq::further_tests(p, points, 1) != uq::further_tests(p, points, 2));
    const auto refused = [&](const char* why) {
        CHECK_THROWS_WITH(uq::calibrate(p, kFew), Catch::Contains(why));
    };
    p.tests[0].value = std::nan("");
    refused("must be a finite number");
    p.tests[0] = {17, 3.0};
    refused("an answer that there is not");
    p.tests.clear();
    refused("there must be a test");
    p = problem(true);
    p.tests = {{0, 3.0}};
    p.quantity.back() = 2;
    refused("no gaps");
}
