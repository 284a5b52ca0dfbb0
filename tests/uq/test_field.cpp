#include "uq/fields/field.hpp"

#include "tests/uq/field_scenes.hpp"
#include "uq/designs/stream.hpp"
#include "uq/fields/karhunen.hpp"
#include "uq/fields/kernel.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <stdexcept>

using namespace uq;

namespace {

std::vector<std::uint64_t> first_ids(std::size_t n)
{
    std::vector<std::uint64_t> id(n);
    std::iota(id.begin(), id.end(), 0u);
    return id;
}

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
    "bit, by either basis",
    "[uq][field]")
{
    const auto sites = scenes::wall_grid();
    const auto id = first_ids(21);
    const Eigen::MatrixXd zero = correlation_matrix(independent_sites(), sites);
    const Eigen::MatrixXd one = correlation_matrix(one_for_all(), sites);
    const Eigen::MatrixXd z = field_coordinates(5, id, 180), y = field_coordinates(5, id, 1);
    CHECK(same_bits(realise(cholesky_basis(zero), z), z));
    CHECK(same_bits(realise(karhunen_basis(zero, {.share = 1.0}), z), z));
    CHECK(same_bits(realise(cholesky_basis(one), y), y.replicate(1, 180)));
    CHECK(same_bits(realise(karhunen_basis(one), y), y.replicate(1, 180)));
}

TEST_CASE("field: product kernels with a factor 0 or 1 reach the same ends", "[uq][field]")
{
    const auto sites = scenes::wall_grid();
    const Kernel k{{Exponential{1.0}, GroupCorrelation{Group::all, 0.0}}};
    const Eigen::MatrixXd z = field_coordinates(5, first_ids(3), 180);
    CHECK(same_bits(realise(cholesky_basis(correlation_matrix(k, sites)), z), z));
}

TEST_CASE("field: the blocked product is the product, for all sizes", "[uq][field]")
{
    const Eigen::Index n = GENERATE(1, 2, 7, 8, 9, 33), p = GENERATE(1, 3, 4, 5, 41);
    const Eigen::Index r = GENERATE(1, 6);
    FieldBasis basis;
    basis.map = field_coordinates(2, first_ids(static_cast<std::size_t>(p)), r);
    const Eigen::MatrixXd z = field_coordinates(3, first_ids(static_cast<std::size_t>(n)), r);
    const Eigen::MatrixXd g = realise(basis, z);
    REQUIRE(g.rows() == n);
    REQUIRE(g.cols() == p);
    CHECK((g - z * basis.map.transpose()).cwiseAbs().maxCoeff() < 2e-15 * 6.0);
}

TEST_CASE("field: coordinates of a sample are the normals of its own stream, in order",
          "[uq][field]")
{
    const std::vector<std::uint64_t> id{0, 17, 4};
    const Eigen::MatrixXd z = field_coordinates(3, id, 301);
    for (std::size_t i = 0; i < id.size(); ++i) {
        Stream stream(3, id[i], Purpose::field);
        for (Eigen::Index j = 0; j < 301; ++j)
            REQUIRE(z(static_cast<Eigen::Index>(i), j) == stream.normal());
    }
}

TEST_CASE("field: a sample is the same alone and in a batch, to the bit", "[uq][field]")
{
    const FieldBasis basis =
        cholesky_basis(correlation_matrix(Kernel{{Exponential{0.5}}}, scenes::wall_grid()));
    const auto id = first_ids(50);
    const Eigen::MatrixXd batch = realise(basis, field_coordinates(1, id, 180));
    for (const std::size_t k : {0u, 17u, 49u}) {
        const std::vector<std::uint64_t> alone{id[k]};
        CHECK(same_bits(realise(basis, field_coordinates(1, alone, 180)),
                        batch.row(static_cast<Eigen::Index>(k))));
    }
    CHECK(field_coordinates(2, id, 180) != field_coordinates(1, id, 180));
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
    const auto id = first_ids(20000);
    const FieldBasis basis =
        GENERATE(0, 1) ? cholesky_basis(r) : karhunen_basis(r, {.share = 1.0});
    const Eigen::MatrixXd g = realise(basis, field_coordinates(11, id, basis.map.cols()));
    CHECK(worst_deviation(g, g, r) < 4.5); // 465 pairs: 4.5 is passed by chance once in 300
}

TEST_CASE("field: several variables have the separable correlation", "[uq][field]")
{
    const auto sites = scenes::grid(3, 2, 0.2, 0.1);
    const Eigen::MatrixXd r = correlation_matrix(Kernel{{Exponential{0.3}}}, sites);
    Eigen::MatrixXd c(3, 3);
    c << 1.0, 0.6, -0.5, 0.6, 1.0, 0.0, -0.5, 0.0, 1.0;
    const FieldBasis basis = cholesky_basis(r);
    const auto g = realise(basis, c, field_coordinates(4, first_ids(40000), 18));
    REQUIRE(g.size() == 3);
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
            CHECK(worst_deviation(
                      g[k], g[l],
                      c(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l)) * r) < 4.0);
}

TEST_CASE(
    "field: variables of correlation 0 are fields of their own, of correlation 1 the same "
    "field, to the bit",
    "[uq][field]")
{
    const FieldBasis basis = cholesky_basis(
        correlation_matrix(Kernel{{Exponential{0.3}}}, scenes::grid(3, 2, 0.2, 0.1)));
    const Eigen::MatrixXd z = field_coordinates(4, first_ids(9), 12);
    const auto apart = realise(basis, Eigen::MatrixXd::Identity(2, 2), z);
    CHECK(same_bits(apart[0], realise(basis, z.leftCols(6))));
    CHECK(same_bits(apart[1], realise(basis, z.rightCols(6))));
    const auto tied = realise(basis, Eigen::MatrixXd::Ones(2, 2), z);
    CHECK(same_bits(tied[0], apart[0]));
    CHECK(same_bits(tied[1], apart[0]));
}

TEST_CASE("field: a design on the unit cube becomes normal coordinates, row by row",
          "[uq][field]")
{
    Eigen::MatrixXd u(2, 2);
    u << 0.5, 0.975, 0.025, 1e-10;
    const Eigen::MatrixXd z = normal_coordinates(u);
    CHECK(std::abs(z(0, 0)) < 1e-15);
    CHECK(z(0, 1) == Approx(1.9599639845400545).epsilon(1e-14));
    CHECK(z(1, 0) == Approx(-1.9599639845400545).epsilon(1e-14));
    CHECK(z(1, 1) == Approx(-6.361340902404056).epsilon(1e-13));
    for (const double bad : {0.0, 1.0, std::nan("")}) {
        u(1, 0) = bad;
        CHECK_THROWS_AS(normal_coordinates(u), std::invalid_argument);
    }
}

TEST_CASE("field: coordinates that do not fit or are not finite are refused", "[uq][field]")
{
    const FieldBasis basis = cholesky_basis(Eigen::MatrixXd::Identity(3, 3));
    Eigen::MatrixXd z = Eigen::MatrixXd::Zero(2, 3);
    CHECK_THROWS_AS(realise(basis, z.leftCols(2)), std::invalid_argument);
    CHECK_THROWS_AS(realise(basis, Eigen::MatrixXd::Identity(2, 2), z), std::invalid_argument);
    z(1, 2) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(realise(basis, z), std::invalid_argument);
}
