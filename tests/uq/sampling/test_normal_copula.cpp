#include "uq/designs/normal_copula.hpp"

#include <catch2/catch.hpp>

#include <stdexcept>
#include <vector>

using namespace uq;

namespace {

Eigen::MatrixXd pair_correlation(double rho)
{
    return (Eigen::MatrixXd(2, 2) << 1.0, rho, rho, 1.0).finished();
}

std::vector<Variable> lognormals(std::size_t n)
{
    std::vector<Variable> all;
    for (std::size_t i = 0; i < n; ++i)
        all.push_back(
            {std::string(1, static_cast<char>('a' + i)), {lognormal_from_moments(1.0, 1.0)}});
    return all;
}

} // namespace

TEST_CASE("normal copula: normals keep their correlation; the factor gives it back",
          "[uq][normal_copula]")
{
    const std::vector<Variable> two{{"x", {Normal{1.0, 2.0}}}, {"y", {Normal{-3.0, 0.1}}}};
    const NormalCopula c = normal_copula(two, pair_correlation(0.6));
    CHECK(c.rho_z(1, 0) == Approx(0.6).epsilon(1e-13));
    CHECK((c.factor * c.factor.transpose() - c.rho_z).cwiseAbs().maxCoeff() < 1e-15);
    CHECK(c.factor.isLowerTriangular(0.0));
}

TEST_CASE("normal copula: what cannot be is refused with the variables named and the nearest "
          "shown",
          "[uq][normal_copula]")
{
    const auto two = lognormals(2);
    CHECK_THROWS_WITH(normal_copula(two, pair_correlation(1.2)),
                      Catch::Contains("pearson: the correlation matrix has an entry outside"));
    CHECK_THROWS_WITH(normal_copula(two, Eigen::MatrixXd::Identity(3, 3)),
                      Catch::Contains("pearson"));
    CHECK_THROWS_WITH(normal_copula(two, pair_correlation(-0.6)),
                      Catch::Contains("a, b: correlation -0.6 is not attainable"));

    // A correlation matrix that three lognormals cannot have: on the normal axis it is none.
    Eigen::MatrixXd r(3, 3);
    r << 1, -0.45, -0.1, -0.45, 1, -0.45, -0.1, -0.45, 1;
    CHECK_THROWS_WITH(normal_copula(lognormals(3), r),
                      Catch::Contains("not one of the normal copula"));
    CHECK_THROWS_WITH(normal_copula(lognormals(3), r), Catch::Contains("nearest: [1"));
}
