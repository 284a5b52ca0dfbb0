#include "fragility/modes/mode_lack_of_fit.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <initializer_list>
#include <stdexcept>

using namespace fragility;

namespace {

/// Rocking and mixed walls of 50 under five vertical stresses [MPa].
ModeData fifty_each(std::initializer_list<double> rocking)
{
    ModeData d{Eigen::MatrixXd(5, 1), Eigen::MatrixXd(5, 2)};
    d.covariates << 0.15, 0.5, 0.75, 1.0, 1.25;
    Eigen::Index i = 0;
    for (const double n : rocking) d.counts.row(i++) << n, 50.0 - n;
    return d;
}

} // namespace

TEST_CASE("mode lack of fit: residual deviance of logistic regressions as glm (R)",
          "[fragility][mode_model]")
{
    const ModeData good = fifty_each({45, 30, 24, 12, 8}),
                   bad = fifty_each({50, 18, 17, 12, 12});
    const LackOfFit a = lack_of_fit(fit_modes(good), good),
                    b = lack_of_fit(fit_modes(bad), bad);
    CHECK(a.degrees == 3);
    CHECK(a.deviance == Approx(1.9576536861733).epsilon(1e-9));
    CHECK(a.p_value == Approx(0.5812421941927).epsilon(1e-9));
    CHECK(b.degrees == 3);
    CHECK(b.deviance == Approx(37.629649559338).epsilon(1e-9));
    CHECK(b.p_value == Approx(3.3856607578377e-08).epsilon(1e-7));
}

TEST_CASE("mode lack of fit: residual deviance of three modes as nnet::multinom (R)",
          "[fragility][mode_model]")
{
    ModeData d{Eigen::MatrixXd(7, 1), Eigen::MatrixXd(7, 3)};
    d.covariates << std::log(0.1), std::log(0.2), std::log(0.3), std::log(0.4), std::log(0.6),
        std::log(0.8), 0.0;
    d.counts << 38, 2, 0, 30, 9, 1, 20, 16, 4, 11, 20, 9, 4, 17, 19, 1, 10, 29, 0, 0, 0;
    const LackOfFit f = lack_of_fit(fit_modes(d), d);
    CHECK(f.degrees == 8); // a row without walls has no share
    CHECK(f.deviance == Approx(0.54297909524718).epsilon(1e-8));
    CHECK(f.p_value == Approx(0.99981764840872).epsilon(1e-8));
}

TEST_CASE("mode lack of fit: a line through two shares has nothing to test",
          "[fragility][mode_model]")
{
    ModeData d{Eigen::MatrixXd(2, 1), Eigen::MatrixXd(2, 2)};
    d.covariates << 0.5, 1.0;
    d.counts << 30, 20, 10, 40;
    const LackOfFit f = lack_of_fit(fit_modes(d), d);
    CHECK(f.degrees == 0);
    CHECK(f.deviance == Approx(0.0).margin(1e-9));
    CHECK(f.p_value == 1.0);
}

TEST_CASE("mode lack of fit: other modes or covariates than the model's are refused",
          "[fragility][mode_model]")
{
    const ModeData d = fifty_each({45, 30, 24, 12, 8});
    const ModeModel m = fit_modes(d);
    const ModeData three_modes{d.covariates, Eigen::MatrixXd::Ones(5, 3)},
        two_covariates{Eigen::MatrixXd::Ones(5, 2), d.counts};
    CHECK_THROWS_AS(lack_of_fit(m, three_modes), std::invalid_argument);
    CHECK_THROWS_AS(lack_of_fit(m, two_covariates), std::invalid_argument);
    CHECK_THROWS_AS(lack_of_fit(ModeModel{}, d), std::invalid_argument);
}
