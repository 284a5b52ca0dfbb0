#include "uq/fields/field.hpp"

#include "tests/uq/field_scenes.hpp"
#include "uq/fields/kernel.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

using namespace uq;
using scenes::coordinates;

namespace {

bool same_bits(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() &&
           std::memcmp(a.data(), b.data(),
                       sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

/// Largest distance of the sample correlations from the target, in standard errors: the sample
/// covariance of n normal pairs has variance (1 + r^2) / n about r (mean known).
double worst_deviation(const Eigen::MatrixXd& g, const Eigen::MatrixXd& h,
                       const Eigen::MatrixXd& target)
{
    const double n = static_cast<double>(g.rows());
    const Eigen::ArrayXXd c = (g.transpose() * h / n).array();
    return ((c - target.array()).abs() / ((1.0 + target.array().square()) / n).sqrt())
        .maxCoeff();
}

} // namespace

TEST_CASE(
    "field: correlation 0 is the coordinates themselves, correlation 1 one for all, to the "
    "bit",
    "[uq][field]")
{
    const auto sites = scenes::wall_grid();
    const Eigen::MatrixXd zero = correlation_matrix(scenes::independent_sites(), sites);
    const Eigen::MatrixXd one = correlation_matrix(scenes::one_for_all(), sites);
    const Eigen::MatrixXd z = coordinates(5, 21, 180), y = coordinates(5, 21, 1);
    CHECK(same_bits(realise(cholesky_basis(zero), z), z));
    CHECK(same_bits(realise(cholesky_basis(one), y), y.replicate(1, 180)));
}

TEST_CASE("field: product kernels with a factor 0 or 1 reach the same ends", "[uq][field]")
{
    const auto sites = scenes::wall_grid();
    const Kernel k{{Exponential{1.0}, GroupCorrelation{Group::all, 0.0}}};
    const Eigen::MatrixXd z = coordinates(5, 3, 180);
    CHECK(same_bits(realise(cholesky_basis(correlation_matrix(k, sites)), z), z));
}

TEST_CASE("field: the blocked product is the product, for all sizes", "[uq][field]")
{
    const Eigen::Index n = GENERATE(1, 2, 7, 8, 9, 33), p = GENERATE(1, 3, 4, 5, 41);
    const Eigen::Index r = GENERATE(1, 6);
    FieldBasis basis;
    basis.map = coordinates(2, p, r);
    const Eigen::MatrixXd z = coordinates(3, n, r);
    const Eigen::MatrixXd g = realise(basis, z);
    REQUIRE(g.rows() == n);
    REQUIRE(g.cols() == p);
    CHECK((g - z * basis.map.transpose()).cwiseAbs().maxCoeff() < 2e-15 * 6.0);
}

TEST_CASE("field: a sample is the same alone and in a batch, to the bit", "[uq][field]")
{
    const FieldBasis basis =
        cholesky_basis(correlation_matrix(Kernel{{Exponential{0.5}}}, scenes::wall_grid()));
    const Eigen::MatrixXd z = coordinates(1, 50, 180), batch = realise(basis, z);
    for (const Eigen::Index k : {0, 17, 49})
        CHECK(same_bits(realise(basis, z.row(k)), batch.row(k)));
}

TEST_CASE(
    "field: the sample covariance of many fields is within its standard error of the target",
    "[uq][field]")
{
    const auto sites = scenes::grid(6, 5, 0.2, 0.1);
    const Kernel kernel =
        GENERATE(Kernel{{Exponential{0.5}}}, Kernel{{SquaredExponential{0.5}}},
                 Kernel{{Matern{2.5, 0.3}}}, Kernel{{GroupCorrelation{Group::course, 0.4}}});
    const Eigen::MatrixXd r = correlation_matrix(kernel, sites);
    const FieldBasis basis = cholesky_basis(r);
    const Eigen::MatrixXd g = realise(basis, coordinates(11, 20000, basis.map.cols()));
    CHECK(worst_deviation(g, g, r) < 4.5); // 465 pairs: 4.5 is passed by chance once in 300
}

TEST_CASE("field: coordinates that do not fit or are not finite are refused", "[uq][field]")
{
    const FieldBasis basis = cholesky_basis(Eigen::MatrixXd::Identity(3, 3));
    Eigen::MatrixXd z = Eigen::MatrixXd::Zero(2, 3);
    CHECK_THROWS_AS(realise(basis, z.leftCols(2)), std::invalid_argument);
    z(1, 2) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(realise(basis, z), std::invalid_argument);
}
