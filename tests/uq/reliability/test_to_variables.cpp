#include "uq/reliability/limit_state/to_variables.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

TEST_CASE("to variables: independent ones are their own quantiles", "[uq][to_variables]")
{
    const std::vector<uq::Marginal> two = {{uq::Normal{4.0, 1.0}}, {uq::Lognormal{0.0, 0.5}}};
    const Eigen::MatrixXd u = Eigen::MatrixXd{{0.3, -1.2}, {2.0, 0.7}};
    const Eigen::MatrixXd x = uq::to_variables(two)(u);
    for (Eigen::Index i = 0; i < 2; ++i) {
        CHECK(x(i, 0) == Approx(4.0 + u(i, 0)).epsilon(1e-14));
        CHECK(x(i, 1) == Approx(std::exp(0.5 * u(i, 1))).epsilon(1e-14));
    }
}

TEST_CASE("to variables: of two normal variables with correlation r the second is r u1 + "
          "sqrt(1 - r^2) u2",
          "[uq][to_variables]")
{
    const uq::Marginal standard{uq::Normal{0.0, 1.0}};
    const double r = 0.6;
    const std::vector<uq::Variable> named = {{"a", standard}, {"b", standard}};
    const auto copula = uq::normal_copula(named, Eigen::MatrixXd{{1.0, r}, {r, 1.0}});
    const uq::Map map = uq::to_variables({standard, standard}, copula);
    const Eigen::MatrixXd x = map(Eigen::MatrixXd{{0.5, -2.0}});
    CHECK(x(0, 0) == Approx(0.5).epsilon(1e-12));
    CHECK(x(0, 1) == Approx(r * 0.5 - 2.0 * std::sqrt(1.0 - r * r)).epsilon(1e-9));
    CHECK_THROWS_AS(uq::to_variables({standard}, copula), std::invalid_argument);
}
