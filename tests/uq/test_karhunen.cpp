#include "uq/fields/karhunen.hpp"

#include "tests/uq/field_scenes.hpp"
#include "uq/fields/kernel.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace uq;

namespace {

auto near(double value, double tolerance)
{
    return Approx(value).epsilon(tolerance).margin(0.0);
}

/// Midpoint rule with n points for the modes of exp(-|x - y|) on [0, 1].
Eigen::VectorXd line_modes(int n)
{
    const Eigen::MatrixXd r =
        correlation_matrix(Kernel{{Exponential{1.0}}}, scenes::grid(n, 1, 1.0 / n, 1.0));
    return karhunen_eigenvalues(r).head(5) / n;
}

} // namespace

TEST_CASE(
    "karhunen: the modes of exp(-|x - y|) on [0, 1] are met with the square of the spacing",
    "[uq][karhunen]")
{
    // Ghanem and Spanos (1991): 2 / (1 + w^2), w from the transcendental equations.
    const double exact[] = {.738810809416, .138003775354, .0450884872898, .0213289312873,
                            .0122789138545};
    const Eigen::VectorXd a = line_modes(40), b = line_modes(80), c = line_modes(160);
    for (int k = 0; k < 5; ++k) {
        CHECK((a[k] - b[k]) / (b[k] - c[k]) == Approx(4.0).epsilon(0.02));
        const double once = b[k] + (b[k] - a[k]) / 3.0, again = c[k] + (c[k] - b[k]) / 3.0;
        CHECK(again + (again - once) / 15.0 == near(exact[k], 1e-8));
    }
}

TEST_CASE("karhunen: eigenvalues and modes of a 15 x 12 grid, exponential", "[uq][karhunen]")
{
    const Eigen::VectorXd values = karhunen_eigenvalues(
        correlation_matrix(Kernel{{Exponential{1.0}}}, scenes::wall_grid()));
    const double exact[] = {49.53035508, 23.4152126, 14.9757853, 10.20239696, 9.083968362};
    for (int k = 0; k < 5; ++k) CHECK(values[k] == near(exact[k], 1e-9));
    CHECK(values[179] == near(.09222415083, 1e-9));
    CHECK(values.sum() == near(180.0, 1e-13));
    CHECK(modes_for(values, 0.90) == 56);
    CHECK(modes_for(values, 0.95) == 103);
    CHECK(modes_for(values, 0.99) == 162);
    CHECK(modes_for(values, 1e-9) == 1);
}

TEST_CASE("karhunen: eigenvalues of a 15 x 12 grid, squared exponential", "[uq][karhunen]")
{
    const Eigen::VectorXd values = karhunen_eigenvalues(
        correlation_matrix(Kernel{{SquaredExponential{1.0}}}, scenes::wall_grid()));
    const double exact[] = {44.19893135, 31.18697642, 22.15458628, 17.56858151, 15.63238157};
    for (int k = 0; k < 5; ++k) CHECK(values[k] == near(exact[k], 1e-9));
    CHECK(values.minCoeff() >= 0.0);
}

TEST_CASE(
    "karhunen: what is dropped is the tail of the eigenvalues, and no site loses more than "
    "the worst",
    "[uq][karhunen]")
{
    const Eigen::MatrixXd r =
        correlation_matrix(Kernel{{Exponential{1.0}}}, scenes::wall_grid());
    const Eigen::VectorXd all = karhunen_eigenvalues(r);
    const FieldBasis basis = karhunen_basis(r, {.share = 0.95, .unit_variance = false});
    REQUIRE(basis.map.cols() == 103);
    CHECK(basis.dropped == near(all.tail(77).sum() / 180.0, 1e-12));
    CHECK(basis.dropped < 0.05);
    const Eigen::VectorXd lost = 1.0 - basis.map.rowwise().squaredNorm().array();
    CHECK(basis.worst_dropped == lost.maxCoeff());
    CHECK(lost[basis.worst_site] == basis.worst_dropped);
    CHECK(basis.worst_dropped > basis.dropped);
    CHECK((basis.map * basis.map.transpose() - r).norm() == near(all.tail(77).norm(), 1e-10));
}

TEST_CASE("karhunen: with all modes nothing is lost; unit variance makes up for what is",
          "[uq][karhunen]")
{
    const Eigen::MatrixXd r =
        correlation_matrix(Kernel{{Matern{1.5, 0.5}}}, scenes::wall_grid());
    const FieldBasis whole = karhunen_basis(r, {.share = 1.0, .unit_variance = false});
    CHECK((whole.map * whole.map.transpose() - r).cwiseAbs().maxCoeff() < 1e-13);
    CHECK(whole.dropped < 1e-13);
    const FieldBasis ten = karhunen_basis(r, {.modes = 10});
    CHECK(ten.map.cols() == 10);
    CHECK((ten.map.rowwise().squaredNorm().array() - 1.0).abs().maxCoeff() < 1e-14);
    CHECK(ten.worst_dropped > 0.1); // still said
}

TEST_CASE("karhunen: the sign of a mode is that of its largest entry, positive",
          "[uq][karhunen]")
{
    const Eigen::MatrixXd r =
        correlation_matrix(Kernel{{Exponential{0.3}}}, scenes::grid(5, 3, 0.2, 0.1));
    const FieldBasis basis = karhunen_basis(r, {.share = 1.0, .unit_variance = false});
    for (const auto mode : basis.map.colwise())
        CHECK(mode.maxCoeff() >= mode.cwiseAbs().maxCoeff() * (1.0 - 1e-12));
}

TEST_CASE("karhunen: one value for all and independent sites keep their coordinates",
          "[uq][karhunen]")
{
    const auto sites = scenes::grid(6, 4, 0.2, 0.1);
    CHECK(karhunen_basis(correlation_matrix(one_for_all(), sites)).map ==
          Eigen::MatrixXd::Ones(24, 1));
    CHECK(karhunen_basis(correlation_matrix(independent_sites(), sites), {.share = 1.0}).map ==
          Eigen::MatrixXd::Identity(24, 24));
}

TEST_CASE("karhunen: bad options are refused", "[uq][karhunen]")
{
    const Eigen::MatrixXd r = Eigen::MatrixXd::Identity(3, 3);
    CHECK_THROWS_AS(karhunen_basis(r, {.share = 0.0}), std::invalid_argument);
    CHECK_THROWS_AS(karhunen_basis(r, {.share = 1.1}), std::invalid_argument);
    CHECK_THROWS_AS(karhunen_basis(r, {.modes = 4}), std::invalid_argument);
    CHECK_THROWS_AS(karhunen_basis(r, {.modes = 2}), std::invalid_argument); // site 2 has none
    CHECK_NOTHROW(karhunen_basis(r, {.modes = 2, .unit_variance = false}));
    Eigen::MatrixXd indefinite = r;
    indefinite(0, 1) = indefinite(1, 0) = indefinite(0, 2) = indefinite(2, 0) = 0.9;
    CHECK_THROWS_AS(karhunen_eigenvalues(indefinite), std::invalid_argument);
}
