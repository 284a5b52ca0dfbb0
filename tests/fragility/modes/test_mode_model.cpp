#include "core/interval.hpp"
#include "fragility/modes/equal_modes.hpp"
#include "fragility/modes/mode_model.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace fragility;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

auto near(double value, double tolerance = 1e-9)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

ModeData three_states()
{
    ModeData d{MatrixXd(6, 1), MatrixXd(6, 3)};
    d.covariates << std::log(0.1), std::log(0.2), std::log(0.3), std::log(0.4), std::log(0.6),
        std::log(0.8);
    d.counts << 38, 2, 0, 30, 9, 1, 20, 16, 4, 11, 20, 9, 4, 17, 19, 1, 10, 29;
    return d;
}

/// Vertical stress [MPa] and friction angle [deg] of fifteen walls, one of two modes.
ModeData fifteen_walls()
{
    ModeData d{MatrixXd(15, 2), MatrixXd(15, 2)};
    d.covariates << .15, 30, .15, 35, .15, 41, .5, 29, .5, 33, .5, 38, .75, 27, .75, 34, .75,
        39, 1, 31, 1, 36, 1, 40, 1.25, 28, 1.25, 32, 1.25, 37;
    VectorXd y(15);
    y << 0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1;
    d.counts.col(1) = y;
    d.counts.col(0) = 1.0 - y.array();
    return d;
}

ModeData line(std::vector<double> x, std::vector<double> second)
{
    const auto n = static_cast<Eigen::Index>(x.size());
    ModeData d{MatrixXd(n, 1), MatrixXd(n, 2)};
    for (Eigen::Index i = 0; i < n; ++i) {
        d.covariates(i, 0) = x[static_cast<std::size_t>(i)];
        d.counts(i, 1) = second[static_cast<std::size_t>(i)];
        d.counts(i, 0) = 1.0 - d.counts(i, 1);
    }
    return d;
}

VectorXd at(std::initializer_list<double> x)
{
    VectorXd v(static_cast<Eigen::Index>(x.size()));
    std::copy(x.begin(), x.end(), v.begin());
    return v;
}

} // namespace

TEST_CASE(
    "mode model: multinomial logit as multinom (R, nnet, its search finished by Newton steps)",
    "[fragility][mode_model]")
{
    const ModeModel m = fit_modes(three_states());
    REQUIRE(m.outcome == ModelOutcome::converged);
    CHECK(m.coefficients(0, 0) == near(2.7959144437042, 1e-12));
    CHECK(m.coefficients(0, 1) == near(2.4799572860067, 1e-12));
    CHECK(m.coefficients(1, 0) == near(4.2846224828381, 1e-12));
    CHECK(m.coefficients(1, 1) == near(4.9342823158146, 1e-12));
    CHECK(m.deviance == near(355.915430844, 1e-11));
    CHECK(m.aic == near(363.915430844, 1e-11));
    CHECK(m.std_errors(0, 0) == near(0.502455133172, 1e-6));
    CHECK(m.std_errors(0, 1) == near(0.388786929557, 1e-6));
    CHECK(m.std_errors(1, 0) == near(0.574439285353, 1e-6));
    CHECK(m.std_errors(1, 1) == near(0.604813322374, 1e-6));
}

TEST_CASE("mode model: logistic regression as glm (R)", "[fragility][mode_model]")
{
    const ModeModel m = fit_modes(fifteen_walls());
    REQUIRE(m.outcome == ModelOutcome::converged);
    CHECK(m.coefficients(0, 0) == near(10.877994896996));
    CHECK(m.coefficients(0, 1) == near(8.451599570685));
    CHECK(m.coefficients(0, 2) == near(-0.490999336538));
    CHECK(m.std_errors(0, 0) == near(8.905701876457, 1e-8));
    CHECK(m.std_errors(0, 1) == near(4.811518968718, 1e-8));
    CHECK(m.std_errors(0, 2) == near(0.316746698887, 1e-8));
    CHECK(m.log_likelihood == near(-4.11256446211));
}

TEST_CASE("mode model: derivatives agree with differences", "[fragility][mode_model]")
{
    const ModeData d = three_states();
    const MatrixXd design = with_constant(d.covariates);
    const VectorXd beta = at({0.3, 0.8, -0.4, 1.1});
    const Local plain = mode_likelihood(design, d.counts, beta);
    const Local firth = penalised_mode_likelihood(design, d.counts, beta);
    for (Eigen::Index k = 0; k < 4; ++k) {
        const double h = 1e-3;
        const auto moved = [&](double by) {
            VectorXd b = beta;
            b[k] += by;
            return b;
        };
        const auto slope = [&](auto f) {
            return (8.0 * (f(moved(h)) - f(moved(-h))) - (f(moved(2 * h)) - f(moved(-2 * h)))) /
                   (12 * h);
        };
        CHECK(plain.gradient[k] == near(slope([&](const VectorXd& b) {
                                            return mode_likelihood(design, d.counts, b).value;
                                        }),
                                        1e-9));
        CHECK(firth.gradient[k] ==
              near(slope([&](const VectorXd& b) {
                       return penalised_mode_likelihood(design, d.counts, b).value;
                   }),
                   1e-9));
        for (Eigen::Index j = 0; j < 4; ++j)
            CHECK(plain.hessian(j, k) ==
                  near(slope([&](const VectorXd& b) {
                           return mode_likelihood(design, d.counts, b).gradient[j];
                       }),
                       1e-8));
    }
}

TEST_CASE("mode model: exchanging the modes changes nothing but the signs",
          "[fragility][mode_model]")
{
    const ModeData d = three_states();
    ModeData r = d;
    r.counts.col(0) = d.counts.col(2);
    r.counts.col(2) = d.counts.col(0);
    const VectorXd x = at({std::log(0.35)});
    const VectorXd p = mode_probabilities(fit_modes(d), x);
    const VectorXd q = mode_probabilities(fit_modes(r), x);
    CHECK(p.sum() == near(1.0, 1e-14));
    for (int k = 0; k < 3; ++k) {
        CHECK(p[k] == near(q[2 - k]));
        const ModeProbability a = mode_probability(fit_modes(d), k, x);
        const ModeProbability b = mode_probability(fit_modes(r), 2 - k, x);
        CHECK(a.std_error == near(b.std_error, 1e-8));
        CHECK(a.interval.lower == near(b.interval.lower, 1e-8));
        CHECK(a.interval.lower < a.value);
        CHECK(a.interval.upper > a.value);
    }
}

TEST_CASE("mode model: the constant alone gives shares and binomial errors",
          "[fragility][mode_model]")
{
    ModeData d{MatrixXd(1, 0), MatrixXd(1, 3)};
    d.counts << 10, 25, 15;
    const ModeModel m = fit_modes(d);
    REQUIRE(m.outcome == ModelOutcome::converged);
    const ModeProbability p = mode_probability(m, 1, VectorXd());
    CHECK(p.value == near(0.5));
    CHECK(p.std_error == near(std::sqrt(0.25 / 50.0)));
}

TEST_CASE("mode model: separated data are said to be, and Firth's fit is finite",
          "[fragility][mode_model]")
{
    const ModeData whole = line({1, 2, 3, 4, 5, 6}, {0, 0, 0, 1, 1, 1});
    CHECK(fit_modes(whole).outcome == ModelOutcome::separated);
    const ModeModel f = fit_modes_safely(whole);
    REQUIRE(f.outcome == ModelOutcome::converged);
    CHECK(f.penalty == ModePenalty::firth);
    CHECK_FALSE(f.reason.empty());
    CHECK(f.coefficients(0, 0) == near(-3.95120805022, 1e-5)); // R, nlm on the same function
    CHECK(f.coefficients(0, 1) == near(1.12891607296, 1e-5));
    CHECK(-f.coefficients(0, 0) / f.coefficients(0, 1) == near(3.5, 1e-6)); // by symmetry
    // quasi: one value at which both occur
    CHECK(fit_modes(line({1, 2, 3, 3, 4, 5}, {0, 0, 0, 1, 1, 1})).outcome ==
          ModelOutcome::separated);
    // a single wall out of order: finite
    CHECK(fit_modes(line({1, 2, 3, 4, 5, 6}, {0, 0, 1, 0, 1, 1})).outcome ==
          ModelOutcome::converged);
    // one covariate separates, another does not matter
    ModeData two = whole;
    two.covariates.conservativeResize(6, 2);
    two.covariates.col(1) = at({3, 1, 2, 2, 3, 1});
    CHECK(fit_modes(two).outcome == ModelOutcome::separated);
}

TEST_CASE("mode model: one of three modes apart is separated too", "[fragility][mode_model]")
{
    ModeData d{MatrixXd(4, 1), MatrixXd(4, 3)};
    d.covariates << 0.15, 0.5, 1.0, 1.25;
    d.counts << 20, 0, 0, 0, 9, 11, 0, 8, 12, 0, 3, 17;
    CHECK(fit_modes(d).outcome == ModelOutcome::separated);
    const ModeModel f = fit_modes_safely(d);
    REQUIRE(f.outcome == ModelOutcome::converged);
    CHECK(mode_probabilities(f, at({0.15}))[0] > 0.9);
    CHECK(f.coefficients.allFinite());
}

TEST_CASE("mode model: Firth's fit of shares adds half a wall to each mode",
          "[fragility][mode_model]")
{
    // Jeffreys' prior of a multinomial: (n_k + 1/2) / (n + K/2)
    ModeData d{MatrixXd(1, 0), MatrixXd(1, 3)};
    d.counts << 10, 0, 15;
    CHECK(fit_modes(d).outcome == ModelOutcome::absent_mode);
    const VectorXd p = mode_probabilities(fit_modes_safely(d), VectorXd());
    CHECK(p[0] == near(10.5 / 26.5, 1e-6));
    CHECK(p[1] == near(0.5 / 26.5, 1e-6));
    CHECK(p[2] == near(15.5 / 26.5, 1e-6));
}

TEST_CASE("mode model: what cannot be fitted is named", "[fragility][mode_model]")
{
    CHECK(fit_modes({}).outcome == ModelOutcome::no_data);
    ModeData d = three_states();
    d.covariates(0, 0) = std::nan("");
    CHECK(fit_modes(d).outcome == ModelOutcome::invalid_value);
    d = three_states();
    d.covariates.setConstant(0.5);
    CHECK(fit_modes(d).outcome == ModelOutcome::collinear);
    d = three_states();
    d.counts.col(1).setZero();
    d.counts.col(2).setZero();
    CHECK(fit_modes(d).outcome == ModelOutcome::no_contrast);
    d = three_states();
    d.counts(0, 0) = -1.0;
    CHECK(fit_modes(d).outcome == ModelOutcome::invalid_value);
    CHECK_THROWS_AS(mode_probabilities(fit_modes(d), at({1.0})), std::invalid_argument);
    CHECK_THROWS_AS(mode_probabilities(fit_modes(three_states()), at({1.0, 2.0})),
                    std::invalid_argument);
    CHECK_THROWS_AS(mode_probability(fit_modes(three_states()), 3, at({1.0})),
                    std::invalid_argument);
}

TEST_CASE("equal modes: where two modes are equally likely, with three intervals",
          "[fragility][equal_modes]")
{
    const ModeData d = fifteen_walls();
    const ModeModel m = fit_modes(d);
    const double stress = GENERATE(0.5, 0.75, 1.0);
    const EqualModes e = equal_modes(m, d, 0, 1, 1, at({stress, 0.0}), 0.9);
    REQUIRE(e.found);
    const VectorXd p = mode_probabilities(m, at({stress, e.at}));
    CHECK(p[0] == near(0.5));
    // the ends of Fieller's interval: the predictor is 1.645 of its standard errors from zero
    for (const double t : {e.fieller.lower, e.fieller.upper}) {
        if (std::isinf(t)) continue;
        const VectorXd x = at({1.0, stress, t});
        const double eta = m.coefficients.row(0) * x;
        CHECK(std::abs(eta) ==
              near(1.6448536269514722 * std::sqrt(x.dot(m.covariance * x)), 1e-8));
    }
    CHECK(e.delta.upper - e.at == near(1.6448536269514722 * e.std_error));
    CHECK(e.profile.lower < e.at);
    CHECK(e.profile.upper > e.at);
    const EqualModes back = equal_modes(m, d, 1, 0, 1, at({stress, 0.0}), 0.9);
    CHECK(back.at == near(e.at));
    CHECK(back.profile.upper == near(e.profile.upper, 1e-7));
}

TEST_CASE("equal modes: with many walls the three intervals are one",
          "[fragility][equal_modes]")
{
    ModeData d = three_states();
    d.counts *= 1e4;
    const ModeModel m = fit_modes(d);
    const EqualModes e = equal_modes(m, d, 1, 2, 0, at({0.0}));
    REQUIRE(e.found);
    CHECK(
        e.at ==
        near(-(4.2846224828381 - 2.7959144437042) / (4.9342823158146 - 2.4799572860067), 1e-8));
    for (const core::Interval& i : {e.fieller, e.profile}) {
        CHECK(i.lower == Approx(e.delta.lower).margin(0.01 * e.std_error).epsilon(0));
        CHECK(i.upper == Approx(e.delta.upper).margin(0.01 * e.std_error).epsilon(0));
    }
}

TEST_CASE("equal modes: without a significant slope there is no bound",
          "[fragility][equal_modes]")
{
    const ModeData d = line({1, 2, 3, 4, 5, 6, 7, 8}, {0, 1, 1, 0, 0, 1, 1, 1});
    const ModeModel m = fit_modes(d);
    const EqualModes e = equal_modes(m, d, 0, 1, 0, at({0.0}));
    REQUIRE(e.found);
    CHECK(std::isinf(e.fieller.lower));
    CHECK(std::isinf(e.fieller.upper));
    CHECK(std::isinf(e.profile.lower));
    CHECK_THROWS_AS(equal_modes(m, d, 0, 0, 0, at({0.0})), std::invalid_argument);
    CHECK_THROWS_AS(equal_modes(m, d, 0, 1, 1, at({0.0})), std::invalid_argument);
}
