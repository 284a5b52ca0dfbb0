#include "uq/fields/field_marginal.hpp"

#include "tests/uq/field_scenes.hpp"
#include "uq/fields/field.hpp"
#include "uq/fields/kernel.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

using namespace uq;

TEST_CASE("field marginal: every site has the marginal, whatever the correlation",
          "[uq][field_marginal]")
{
    const Kernel kernel =
        GENERATE(independent_sites(), Kernel{{Exponential{0.3}}}, one_for_all());
    const Eigen::MatrixXd r = correlation_matrix(kernel, scenes::grid(3, 2, 0.2, 0.1));
    const FieldBasis basis = cholesky_basis(r);
    std::vector<std::uint64_t> id(20000);
    std::iota(id.begin(), id.end(), 0u);
    const Marginal strength{lognormal_from_moments(3.7, 0.30)}; // Table 5 of the paper [MPa]
    const Eigen::MatrixXd f =
        translate(realise(basis, field_coordinates(1, id, basis.map.cols())), strength);
    const double n = 20000.0;
    for (const double p : {0.05, 0.5, 0.95}) {
        const double q = quantile(strength, p);
        for (Eigen::Index i = 0; i < f.cols(); ++i) {
            const auto below = static_cast<double>((f.col(i).array() <= q).count());
            CHECK(std::abs(below / n - p) < 4.0 * std::sqrt(p * (1.0 - p) / n));
        }
    }
}

TEST_CASE("field marginal: a lognormal field has the correlation of its closed form",
          "[uq][field_marginal]")
{
    // (exp(r s^2) - 1) / (exp(s^2) - 1), s: sd of the logarithm
    const Eigen::MatrixXd r = correlation_matrix(Kernel{{GroupCorrelation{Group::all, 0.5}}},
                                                 scenes::grid(2, 1, 0.2, 0.1));
    std::vector<std::uint64_t> id(100000);
    std::iota(id.begin(), id.end(), 0u);
    const Lognormal law = lognormal_from_moments(1.0, 0.5);
    const Eigen::MatrixXd f =
        translate(realise(cholesky_basis(r), field_coordinates(2, id, 2)), Marginal{law});
    const Eigen::MatrixXd d = f.rowwise() - f.colwise().mean();
    const double found = d.col(0).dot(d.col(1)) / (d.col(0).norm() * d.col(1).norm());
    const double s2 = law.sigma_log * law.sigma_log;
    CHECK(found == Approx(std::expm1(0.5 * s2) / std::expm1(s2)).margin(0.012));
}

TEST_CASE("field marginal: one value for all and independent sites are the marginal of the "
          "coordinates, to the bit",
          "[uq][field_marginal]")
{
    const auto sites = scenes::wall_grid();
    const Marginal friction{normal_from_moments(31.8, 0.20), 0.0, 90.0};
    const std::vector<std::uint64_t> id{3, 5, 8};
    const Eigen::MatrixXd z = field_coordinates(9, id, 180), y = field_coordinates(9, id, 1);
    const auto field = [&](const Kernel& k, const Eigen::MatrixXd& coordinates) {
        return translate(realise(cholesky_basis(correlation_matrix(k, sites)), coordinates),
                         friction);
    };
    const Eigen::MatrixXd spatial = field(independent_sites(), z),
                          whole = field(one_for_all(), y);
    for (Eigen::Index i = 0; i < 3; ++i)
        for (Eigen::Index j = 0; j < 180; ++j) {
            CHECK(spatial(i, j) == from_normal(friction, z(i, j)));
            CHECK(whole(i, j) == from_normal(friction, y(i, 0)));
        }
}
