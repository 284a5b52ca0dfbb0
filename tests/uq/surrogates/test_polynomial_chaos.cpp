#include "tests/uq/latin_scene.hpp"
#include "tests/uq/sensitivity_scenes.hpp"
#include "uq/designs/sobol.hpp"
#include "uq/surrogates/chaos_fit.hpp"
#include "uq/surrogates/process_fit.hpp"

#include <catch2/catch.hpp>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <stdexcept>

using namespace uq;

namespace {

std::vector<PolynomialFamily> legendre(std::size_t d)
{
    return std::vector<PolynomialFamily>(d, PolynomialFamily::legendre);
}

double coefficient(const PolynomialChaos& chaos, int degree)
{
    for (Eigen::Index t = 0; t < chaos.degrees.rows(); ++t)
        if (chaos.degrees(t, 0) == degree) return chaos.coefficients(t);
    return 0.0;
}

double q2(const Eigen::VectorXd& truth, const Eigen::VectorXd& said)
{
    return 1.0 - (truth - said).squaredNorm() / (truth.array() - truth.mean()).square().sum();
}

/// Flow through a borehole (Harper and Gupta 1983) and its eight variables.
const std::vector<Marginal> kBorehole = {
    {Normal{0.1, 0.0161812}},  {Lognormal{7.71, 1.0056}}, {Uniform{63070.0, 115600.0}},
    {Uniform{990.0, 1110.0}},  {Uniform{63.1, 116.0}},    {Uniform{700.0, 820.0}},
    {Uniform{1120.0, 1680.0}}, {Uniform{9855.0, 12045.0}}};

Eigen::MatrixXd borehole_points(const Eigen::MatrixXd& u)
{
    Eigen::MatrixXd x(u.rows(), 8);
    for (Eigen::Index i = 0; i < u.rows(); ++i)
        for (Eigen::Index j = 0; j < 8; ++j)
            x(i, j) = quantile(kBorehole[static_cast<std::size_t>(j)], u(i, j));
    return x;
}

Eigen::VectorXd borehole(const Eigen::MatrixXd& x)
{
    const auto c = [&](Eigen::Index j) { return x.col(j).array(); };
    const Eigen::ArrayXd ln = (c(1) / c(0)).log();
    return 2.0 * M_PI * c(2) * (c(3) - c(5)) /
           (ln * (1.0 + 2.0 * c(6) * c(2) / (ln * c(0).square() * c(7)) + c(2) / c(4)));
}

} // namespace

TEST_CASE("polynomials: orthonormal under their own measure", "[uq][polynomials]")
{
    // 20 points of Gauss-Legendre, by the eigenvalues of Golub and Welsch (1969): exact to
    // degree 39
    const bool hermite = GENERATE(false, true);
    constexpr int kPoints = 20, kMost = 8;
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(kPoints, kPoints);
    for (int k = 1; k < kPoints; ++k)
        jacobi(k, k - 1) = jacobi(k - 1, k) =
            hermite ? std::sqrt(k) : k / std::sqrt(4.0 * k * k - 1.0);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> rule(jacobi);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(kMost + 1, kMost + 1);
    for (int i = 0; i < kPoints; ++i) {
        const Eigen::VectorXd p =
            polynomials(hermite ? PolynomialFamily::hermite : PolynomialFamily::legendre, kMost,
                        rule.eigenvalues()(i));
        gram += std::pow(rule.eigenvectors()(0, i), 2) * p * p.transpose();
    }
    CHECK((gram - Eigen::MatrixXd::Identity(kMost + 1, kMost + 1)).norm() < 1e-12);
}

TEST_CASE("polynomials: coordinates are those of the probabilities", "[uq][polynomials]")
{
    CHECK(family_of({Uniform{2.0, 4.0}}) == PolynomialFamily::legendre);
    CHECK(coordinate({Uniform{2.0, 4.0}}, 3.5) == Approx(0.5).epsilon(1e-14));
    CHECK(coordinate({Uniform{2.0, 4.0}}, 5.0) == 1.0);
    CHECK(family_of({Lognormal{0.0, 0.5}}) == PolynomialFamily::hermite);
    CHECK(coordinate({Lognormal{1.0, 0.5}}, std::exp(2.0)) == Approx(2.0).epsilon(1e-12));
    CHECK_THROWS_AS(coordinates(kBorehole, Eigen::MatrixXd::Zero(1, 2)), std::invalid_argument);
}

namespace {

/// Points and weights (which add up to 1) of an exact rule of GSL, whose Jacobi weight has the
/// other order of exponents in its names but the same meaning: (1 - c)^a (1 + c)^b.
struct Rule {
    Eigen::VectorXd at, weight;
};

Rule exact_rule(const PolynomialFamily& f, std::size_t n)
{
    const bool jacobi = f.kind == PolynomialFamily::jacobi;
    gsl_integration_fixed_workspace* const w = gsl_integration_fixed_alloc(
        jacobi ? gsl_integration_fixed_jacobi : gsl_integration_fixed_laguerre, n,
        jacobi ? -1.0 : 0.0, 1.0, f.a, jacobi ? f.b : 0.0);
    const auto size = static_cast<Eigen::Index>(n);
    Rule r{Eigen::Map<const Eigen::VectorXd>(gsl_integration_fixed_nodes(w), size),
           Eigen::Map<const Eigen::VectorXd>(gsl_integration_fixed_weights(w), size)};
    gsl_integration_fixed_free(w);
    r.weight /= r.weight.sum();
    return r;
}

} // namespace

TEST_CASE("polynomials: those of beta and gamma variables are orthonormal by an exact rule",
          "[uq][polynomials]")
{
    const auto family = GENERATE(PolynomialFamily(PolynomialFamily::jacobi, 1.5, 0.5),
                                 PolynomialFamily(PolynomialFamily::jacobi, -0.5, -0.5),
                                 PolynomialFamily(PolynomialFamily::jacobi, 3.0, 0.0),
                                 PolynomialFamily(PolynomialFamily::laguerre, 0.0),
                                 PolynomialFamily(PolynomialFamily::laguerre, 2.5));
    constexpr int kMost = 8;
    const Rule rule = exact_rule(family, 20);
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(kMost + 1, kMost + 1);
    for (Eigen::Index i = 0; i < rule.at.size(); ++i) {
        const Eigen::VectorXd p = polynomials(family, kMost, rule.at(i));
        gram += rule.weight(i) * p * p.transpose();
    }
    CAPTURE(name(family));
    CHECK((gram - Eigen::MatrixXd::Identity(kMost + 1, kMost + 1)).cwiseAbs().maxCoeff() <
          1e-12);
}

TEST_CASE(
    "polynomials: beta variables have Jacobi's, gamma variables Laguerre's, whole ones only",
    "[uq][polynomials]")
{
    const Marginal beta{Beta{2.0, 4.0, 10.0, 30.0}}, gamma{Gamma{3.0, 0.5}};
    CHECK(family_of(beta) == PolynomialFamily(PolynomialFamily::jacobi, 3.0, 1.0));
    CHECK(family_of(gamma) == PolynomialFamily(PolynomialFamily::laguerre, 2.0));
    CHECK(coordinate(beta, 15.0) == -0.5);
    CHECK(coordinate(beta, 31.0) == 1.0);
    CHECK(coordinate(gamma, 2.0) == 4.0);
    CHECK(family_of({Beta{2.0, 4.0, 10.0, 30.0}, 12.0}) == PolynomialFamily::legendre);
    CHECK(family_of({Gamma{3.0, 0.5}, 0.1}) == PolynomialFamily::hermite);
    CHECK(family_of({Beta{2.0, 4.0, 10.0, 30.0}, 0.0, 90.0}).kind == PolynomialFamily::jacobi);
    CHECK(family_of({Gamma{3.0, 0.5}, 0.0, 1e3}).kind == PolynomialFamily::laguerre);
    CHECK(family_of({Gamma{3.0, 0.5}, 0.0, 5.0}) == PolynomialFamily::hermite);
    // the density of the coordinate is that of the family: means of c by its first polynomial
    for (const Marginal& m : {beta, gamma}) {
        const PolynomialFamily f = family_of(m);
        CHECK(polynomials(f, 1, coordinate(m, mean(m)))(1) == Approx(0.0).margin(1e-14));
        CHECK(polynomials(f, 1, coordinate(m, mean(m) + sd(m)))(1) ==
              Approx(1.0).epsilon(1e-13));
        CHECK(family_named(name(f)) == f);
    }
    CHECK(name(PolynomialFamily(PolynomialFamily::jacobi, 0.1, 2.0)) == "jacobi 0.1 2");
    CHECK(family_named("hermite") == PolynomialFamily::hermite);
    CHECK_THROWS_AS(family_named("jacobi 1"), std::invalid_argument);
    CHECK_THROWS_AS(family_named("chebyshev"), std::invalid_argument);
}

TEST_CASE("chaos: indices of a polynomial of beta and gamma variables are those of its moments",
          "[uq][polynomial_chaos]")
{
    // y = x + x z + z^2, x beta, z gamma: conditional means and variances by raw moments
    const std::vector<Marginal> variables = {{Beta{2.0, 3.0, 0.0, 1.0}}, {Gamma{2.0, 0.5}}};
    const Eigen::MatrixXd u = scenes::latin_hypercube(40, 2, 5);
    Eigen::MatrixXd x(40, 2);
    for (Eigen::Index i = 0; i < 40; ++i)
        for (Eigen::Index k = 0; k < 2; ++k) x(i, k) = quantile(variables[k], u(i, k));
    const Eigen::ArrayXd y =
        x.col(0).array() + x.col(0).array() * x.col(1).array() + x.col(1).array().square();
    const ChaosFit fit =
        fit_chaos(families_of(variables), coordinates(variables, x), y.matrix());
    const double vx = 0.04, mz = 1.0, vz = 0.5, m3 = 3.0, m4 = 7.5; // E z^3, E z^4
    const double mx = 0.4, mz2 = 1.5;
    const double by_x = (1.0 + mz) * (1.0 + mz) * vx; // E(y | x) = x (1 + E z) + ...
    const double by_z = mx * mx * vz + 2.0 * mx * (m3 - mz * mz2) + m4 - mz2 * mz2;
    const double both = vx * vz, all = by_x + by_z + both;
    const ChaosIndices s = sobol_indices(fit.chaos);
    CHECK(mean(fit.chaos) == Approx(mx + mx * mz + mz2).epsilon(1e-10));
    CHECK(variance(fit.chaos) == Approx(all).epsilon(1e-10));
    CHECK(s.first(0) == Approx(by_x / all).epsilon(1e-10));
    CHECK(s.first(1) == Approx(by_z / all).epsilon(1e-10));
    CHECK(s.total(0) == Approx((by_x + both) / all).epsilon(1e-10));
    CHECK(s.total(1) == Approx((by_z + both) / all).epsilon(1e-10));
}

TEST_CASE("chaos: hyperbolic sets", "[uq][polynomial_chaos]")
{
    CHECK(hyperbolic_set(3, 4, 1.0).rows() == 35); // (3 + 4)! / 3! / 4!
    const Eigen::MatrixXi q = hyperbolic_set(2, 4, 0.5);
    CHECK(q.rows() == 10); // 0 .. 4 on each axis, and (1, 1)
    CHECK(q.row(0).sum() == 0);
}

TEST_CASE("chaos: coefficients of exp(x)", "[uq][chaos_fit]")
{
    const Eigen::MatrixXd c = 2.0 * scenes::latin_hypercube(60, 1, 1).array() - 1.0;
    const ChaosFit fit = fit_chaos(legendre(1), c, c.col(0).array().exp());
    const double truth[] = {1.1752011936, .6371858832, .1600194423,
                            .0266297265,  .0033217094, .0003315377};
    for (int k = 0; k < 6; ++k)
        CHECK(coefficient(fit.chaos, k) == Approx(truth[k]).epsilon(0).margin(1e-10));
    CHECK(mean(fit.chaos) == Approx(truth[0]).epsilon(0).margin(1e-10));
    CHECK(variance(fit.chaos) == Approx(.4323323584).epsilon(0).margin(1e-10));
    const Eigen::MatrixXd at = Eigen::MatrixXd::Constant(1, 1, 0.3);
    CHECK(predict(fit.chaos, at)(0) == Approx(std::exp(0.3)).epsilon(1e-9));
}

TEST_CASE("chaos: indices of Ishigami's function", "[uq][chaos_fit]")
{
    const Eigen::MatrixXd u = sobol(0, 300, 3, 1);
    const ChaosFit fit = fit_chaos(legendre(3), 2.0 * u.array() - 1.0, scenes::ishigami(u));
    const ChaosIndices s = sobol_indices(fit.chaos);
    for (Eigen::Index k = 0; k < 3; ++k) {
        CHECK(std::abs(s.first(k) - scenes::kIshigamiFirst[static_cast<std::size_t>(k)]) <
              1e-3);
        CHECK(std::abs(s.total(k) - scenes::kIshigamiTotal[static_cast<std::size_t>(k)]) <
              1e-3);
    }
    CHECK(variance(fit.chaos) == Approx(13.8445879407193).epsilon(1e-3));
}

TEST_CASE("chaos: indices of Sobol's g, whose kinks no polynomial has", "[uq][chaos_fit]")
{
    const Eigen::MatrixXd u = sobol(0, 256, 3, 1);
    const ChaosFit fit =
        fit_chaos(legendre(3), 2.0 * u.array() - 1.0, scenes::g_function(u, {0.0, 9.0, 99.0}));
    const ChaosIndices s = sobol_indices(fit.chaos);
    const double first[] = {.986711842, .00986711842, .0000986711840};
    const double total[] = {.990033881, .0131565964, .000132000118};
    for (int k = 0; k < 3; ++k) {
        CHECK(std::abs(s.first(k) - first[k]) < 3e-3);
        CHECK(std::abs(s.total(k) - total[k]) < 3e-3);
        CHECK(s.first(k) <= s.total(k));
    }
}

TEST_CASE("chaos: borehole from 60 samples", "[uq][chaos_fit]")
{
    const Eigen::MatrixXd x = borehole_points(scenes::latin_hypercube(60, 8, 4));
    const Eigen::MatrixXd other = borehole_points(scenes::monte_carlo(2000, 8, 5));
    const Eigen::MatrixXd c = coordinates(kBorehole, x);
    const ChaosFit fit = fit_chaos(families_of(kBorehole), c, borehole(x));
    const double chaos = q2(borehole(other), predict(fit.chaos, coordinates(kBorehole, other)));
    const GaussianProcess p =
        fit_process({c, borehole(x)}, {.kernel = ProcessKernel::squared_exponential,
                                       .trend = ProcessTrend::linear});
    const double process = q2(borehole(other), predict_mean(p, coordinates(kBorehole, other)));
    INFO("chaos " << chaos << ", process " << process);
    CHECK(std::max(chaos, process) > 0.995);
    CHECK(std::min(chaos, process) > 0.98);
}

TEST_CASE("chaos: leave-one-out is what the same terms say when a sample is left out",
          "[uq][chaos_fit]")
{
    const Eigen::MatrixXd u = scenes::latin_hypercube(30, 3, 7);
    const Eigen::MatrixXd c = 2.0 * u.array() - 1.0;
    Eigen::VectorXd y = scenes::ishigami(u);
    const ChaosFit fit = fit_chaos(legendre(3), c, y);
    const Eigen::MatrixXd a = chaos_terms(fit.chaos.families, fit.chaos.degrees, c);
    for (Eigen::Index i = 0; i < 30; ++i) {
        std::vector<Eigen::Index> others;
        for (Eigen::Index j = 0; j < 30; ++j)
            if (j != i) others.push_back(j);
        const Eigen::VectorXd b =
            a(others, Eigen::all).colPivHouseholderQr().solve(y(others).eval());
        CHECK(fit.residual(i) == Approx(y(i) - a.row(i).dot(b)).epsilon(1e-8).margin(1e-10));
    }
}

TEST_CASE("chaos: noise has no terms, and samples left out say so", "[uq][chaos_fit]")
{
    const Eigen::MatrixXd c = 2.0 * scenes::latin_hypercube(80, 4, 9).array() - 1.0;
    Eigen::VectorXd y(80);
    Stream s(9, 0, Purpose::monte_carlo);
    for (double& v : y) v = s.normal();
    const ChaosFit fit = fit_chaos(legendre(4), c, y);
    const double total = (y.array() - y.mean()).square().sum();
    CHECK(1.0 - held_out_residuals(fit, c, y).squaredNorm() / total < 0.1);
    y = c.col(0).array() + 0.5 * c.col(1).array() * c.col(2).array();
    CHECK(held_out_residuals(fit_chaos(legendre(4), c, y), c, y).norm() < 1e-9);
}

TEST_CASE("chaos: bad input is refused", "[uq][chaos_fit]")
{
    const Eigen::MatrixXd c = Eigen::VectorXd::LinSpaced(10, -0.9, 0.9);
    const Eigen::VectorXd y = c.col(0);
    CHECK_THROWS_AS(fit_chaos(legendre(2), c, y), std::invalid_argument);
    CHECK_THROWS_AS(fit_chaos(legendre(1), c, y.head(9)), std::invalid_argument);
    CHECK_THROWS_AS(fit_chaos(legendre(1), c.topRows(2), y.head(2)), std::invalid_argument);
    CHECK_THROWS_WITH(fit_chaos(legendre(1), c, Eigen::VectorXd::Ones(10)),
                      Catch::Contains("does not vary"));
    CHECK_THROWS_AS(fit_chaos(legendre(1), c, y, {.norms = {1.5}}), std::invalid_argument);
}
