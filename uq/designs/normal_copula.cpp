#include "uq/designs/normal_copula.hpp"

#include "core/matrix_factors.hpp"
#include "uq/designs/correlation_matrix.hpp"
#include "uq/designs/nataf.hpp"

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace uq {
namespace {

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

Eigen::MatrixXd normal_correlations(std::span<const Variable> variables,
                                    const Eigen::MatrixXd& rho)
{
    const Eigen::Index d = rho.rows();
    std::vector<Eigen::VectorXd> a;
    for (const Variable& v : variables) a.push_back(hermite_coefficients(v.marginal));
    Eigen::MatrixXd rho_z = Eigen::MatrixXd::Identity(d, d);
    for (Eigen::Index i = 0; i < d; ++i)
        for (Eigen::Index j = 0; j < i; ++j) {
            try {
                rho_z(i, j) = rho_z(j, i) =
                    normal_correlation(a[index(i)], a[index(j)], rho(i, j));
            } catch (const std::invalid_argument& e) {
                throw std::invalid_argument(variables[index(j)].name + ", " +
                                            variables[index(i)].name + ": " + e.what());
            }
        }
    if (core::cholesky(rho_z).info() != Eigen::Success) {
        Eigen::MatrixXd nearest = nearest_correlation(rho_z, 1e-4);
        for (Eigen::Index i = 0; i < d; ++i)
            for (Eigen::Index j = 0; j < d; ++j)
                if (i != j)
                    nearest(i, j) = pearson_of_normals(a[index(i)], a[index(j)], nearest(i, j));
        throw std::invalid_argument(
            "pearson: a correlation matrix, but not one of the normal copula with these "
            "marginals; nearest: " +
            correlation_text(nearest, rho));
    }
    return rho_z;
}

} // namespace

NormalCopula normal_copula(std::span<const Variable> variables, const Eigen::MatrixXd& pearson)
{
    check_correlation(pearson, static_cast<Eigen::Index>(variables.size()), "pearson");
    NormalCopula c{normal_correlations(variables, pearson), {}};
    c.factor = core::cholesky(c.rho_z).matrixL();
    return c;
}

} // namespace uq
