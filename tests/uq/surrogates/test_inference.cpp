#include "uq/inference/adaptive_metropolis.hpp"
#include "uq/inference/chain_diagnostics.hpp"
#include "uq/inference/evidence.hpp"

#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

using Eigen::VectorXd;

double log_normal_density(double x, double mean, double sd)
{
    const double z = (x - mean) / sd;
    return -0.5 * z * z - std::log(sd) - 0.5 * std::log(2.0 * std::numbers::pi);
}

/// Starts around the origin.
Eigen::MatrixXd starts(Eigen::Index d, double spread)
{
    Eigen::MatrixXd s(4, d);
    uq::Stream random(9, 0, uq::Purpose::search);
    for (double& v : s.reshaped()) v = spread * random.normal();
    return s;
}

struct Moment {
    double mean, sd, error; ///< error: of the mean, by the effective size
};

template <class F> Moment moment(const std::vector<uq::Chain>& chains, F value)
{
    const Eigen::Index n = chains.front().draws.rows();
    Eigen::MatrixXd y(n, static_cast<Eigen::Index>(chains.size()));
    for (std::size_t k = 0; k < chains.size(); ++k)
        for (Eigen::Index i = 0; i < n; ++i)
            y(i, static_cast<Eigen::Index>(k)) = value(chains[k].draws.row(i));
    const double mean = y.mean(), sd = std::sqrt((y.array() - mean).square().mean());
    return {mean, sd, sd / std::sqrt(uq::diagnose(y).effective)};
}

/// y = a + b x at 0, 1/4, 1/2, 3/4, 1 with errors of 0.1, a and b N(0, 10^2); the discrepancy,
/// a process of standard deviation 0.3 and length 0.3, is integrated out.
struct Line {
    Eigen::MatrixXd factor;

    explicit Line(double discrepancy)
    {
        Eigen::MatrixXd c(5, 5);
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 5; ++j)
                c(i, j) = discrepancy * discrepancy *
                              std::exp(-0.5 * std::pow((i - j) * 0.25 / 0.3, 2)) +
                          (i == j ? 0.01 : 0.0);
        factor = Eigen::LLT<Eigen::MatrixXd>(c).matrixL();
    }
    double operator()(const VectorXd& t) const
    {
        constexpr std::array<double, 5> y = {1.0, 1.3, 1.9, 2.1, 2.9};
        VectorXd r(5);
        for (int i = 0; i < 5; ++i)
            r(i) = y[static_cast<std::size_t>(i)] - t(0) - t(1) * 0.25 * i;
        const VectorXd z = factor.triangularView<Eigen::Lower>().solve(r);
        return -0.5 * z.squaredNorm() - factor.diagonal().array().log().sum() -
               2.5 * std::log(2.0 * std::numbers::pi) + log_normal_density(t(0), 0.0, 10.0) +
               log_normal_density(t(1), 0.0, 10.0);
    }
};

} // namespace

TEST_CASE("inference: eight schools within three standard errors", "[uq][inference][repeats]")
{
    // Rubin (1981): mu, ln tau and eight scaled effects; flat in mu and tau
    constexpr std::array<double, 8> y = {28, 8, -3, 7, -1, 1, 18, 12},
                                    s = {15, 10, 16, 11, 9, 11, 10, 18};
    const auto density = [&](const VectorXd& t) {
        double sum = t(1); // d tau = tau d ln tau
        for (int i = 0; i < 8; ++i)
            sum += log_normal_density(y[static_cast<std::size_t>(i)],
                                      t(0) + std::exp(t(1)) * t(2 + i),
                                      s[static_cast<std::size_t>(i)]) -
                   0.5 * t(2 + i) * t(2 + i);
        return sum;
    };
    const std::vector<uq::Chain> chains = uq::adaptive_metropolis(
        density, starts(10, 1.0), {.warm_up = 20000, .draws = 150000, .seed = 3});
    const auto close = [](const Moment& m, double exact, double sd) {
        INFO(m.mean << " +- " << m.error << ", exact " << exact);
        CHECK(std::abs(m.mean - exact) < 3.0 * m.error);
        CHECK(m.error < 0.06 * sd);
        CHECK(m.sd == Approx(sd).epsilon(0.1));
    };
    close(moment(chains, [](const auto& t) { return t(0); }), 7.932375, 5.178395);
    close(moment(chains, [](const auto& t) { return std::exp(t(1)); }), 6.575483, 5.650379);
    const auto theta = [&](int i) {
        return moment(chains, [i](const auto& t) { return t(0) + std::exp(t(1)) * t(2 + i); });
    };
    constexpr std::array<double, 8> effects = {11.40026, 7.89455, 6.13075,  7.64468,
                                               5.12642,  6.13854, 10.66698, 8.45682};
    for (int i = 0; i < 8; ++i) {
        const Moment m = theta(i);
        CHECK(std::abs(m.mean - effects[static_cast<std::size_t>(i)]) < 3.0 * m.error);
    }
}

TEST_CASE("inference: a line with and without discrepancy, its evidence to 1 %",
          "[uq][inference]")
{
    struct Exact {
        double discrepancy, a, a_sd, b, b_sd, evidence;
    };
    const Exact e =
        GENERATE(Exact{0.0, 0.92009198, 0.07745321, 1.83977924, 0.12647846, -6.68309310},
                 Exact{0.3, 0.94837781, 0.30210650, 1.93154793, 0.44082821, -6.81989304});
    const Line line(e.discrepancy);
    const std::vector<uq::Chain> chains =
        uq::adaptive_metropolis(line, starts(2, 1.0), {.draws = 20000});
    const Moment a = moment(chains, [](const auto&t) { return t(0); }),
                 b = moment(chains, [](const auto&t) { return t(1); });
    CHECK(std::abs(a.mean - e.a) < 4.0 * a.error);
    CHECK(std::abs(b.mean - e.b) < 4.0 * b.error);
    CHECK(a.sd == Approx(e.a_sd).epsilon(0.05));
    CHECK(b.sd == Approx(e.b_sd).epsilon(0.05));
    const uq::Evidence z = uq::bridge_evidence(line, chains, 1);
    CHECK(z.log_value == Approx(e.evidence).margin(0.01));
    CHECK(z.std_error < 0.01);
    CHECK(std::abs(z.log_value - e.evidence) < 4.0 * z.std_error);
}

TEST_CASE("inference: chains that disagree are told, independent draws count fully",
          "[uq][inference]")
{
    Eigen::MatrixXd y(1000, 4);
    uq::Stream random(5, 0, uq::Purpose::monte_carlo);
    for (double& v : y.reshaped()) v = random.normal();
    CHECK(uq::diagnose(y).r_hat < 1.01);
    CHECK(uq::diagnose(y).effective == Approx(4000.0).epsilon(0.15));
    Eigen::MatrixXd apart = y;
    apart.col(2).array() += 1.0;
    CHECK(uq::diagnose(apart).r_hat > 1.05);
    // autoregressive, correlation 0.9: 19 draws are worth one
    for (Eigen::Index i = 1; i < y.rows(); ++i)
        y.row(i) = 0.9 * y.row(i - 1) + std::sqrt(0.19) * y.row(i);
    CHECK(uq::diagnose(y).effective == Approx(4000.0 / 19.0).epsilon(0.3));
}

TEST_CASE("inference: the same seed gives the same draws; what cannot be drawn is refused",
          "[uq][inference]")
{
    const auto normal = [](const VectorXd& t) { return -0.5 * t.squaredNorm(); };
    const uq::MetropolisOptions few{.warm_up = 200, .draws = 200};
    const auto last = [&](std::uint64_t seed) {
        uq::MetropolisOptions o = few;
        o.seed = seed;
        return uq::adaptive_metropolis(normal, starts(2, 1.0), o).back().draws(199, 1);
    };
    CHECK(last(1) == last(1));
    CHECK(last(1) != last(2));
    const auto nowhere = [](const VectorXd&) {
        return -std::numeric_limits<double>::infinity();
    };
    CHECK_THROWS_WITH(uq::adaptive_metropolis(nowhere, starts(2, 1.0), few),
                      Catch::Contains("starts where the density is zero"));
    CHECK_THROWS_WITH(uq::adaptive_metropolis(normal, starts(2, 1.0).topRows(2), few),
                      Catch::Contains("a row for each chain"));
    CHECK_THROWS_WITH(uq::diagnose(Eigen::MatrixXd::Zero(4, 2)), Catch::Contains("at least 8"));
}
