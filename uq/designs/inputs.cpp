#include "uq/designs/inputs.hpp"

#include "uq/designs/correlation_matrix.hpp"
#include "uq/designs/iman_conover.hpp"
#include "uq/designs/nataf.hpp"
#include "uq/marginals/normal_quantile.hpp"

#include <Eigen/Cholesky>

#include <cstddef>
#include <span>
#include <stdexcept>

namespace uq {
namespace {

Eigen::Index size(const JointDistribution& j)
{
    return static_cast<Eigen::Index>(j.marginals.size());
}

std::size_t index(Eigen::Index i) { return static_cast<std::size_t>(i); }

void check_marginals(const Inputs& inputs)
{
    if (inputs.variables.empty())
        throw std::invalid_argument("inputs: no variables; one at least");
    for (const Variable& v : inputs.variables) {
        try {
            check(v.marginal);
        } catch (const std::invalid_argument& e) {
            throw std::invalid_argument(v.name + ": " + e.what());
        }
    }
}

/// @param rho of the variables
Eigen::MatrixXd nataf(const Inputs& inputs, const Eigen::MatrixXd& rho)
{
    const Eigen::Index d = rho.rows();
    std::vector<Eigen::VectorXd> a;
    for (const Variable& v : inputs.variables) a.push_back(hermite_coefficients(v.marginal));
    Eigen::MatrixXd rho_z = Eigen::MatrixXd::Identity(d, d);
    for (Eigen::Index i = 0; i < d; ++i)
        for (Eigen::Index j = 0; j < i; ++j) {
            try {
                rho_z(i, j) = rho_z(j, i) =
                    normal_correlation(a[index(i)], a[index(j)], rho(i, j));
            } catch (const std::invalid_argument& e) {
                throw std::invalid_argument(inputs.variables[index(j)].name + ", " +
                                            inputs.variables[index(i)].name + ": " + e.what());
            }
        }
    if (Eigen::LLT<Eigen::MatrixXd>(rho_z).info() != Eigen::Success) {
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

Eigen::MatrixXd normal_correlations(const Inputs& inputs)
{
    const auto d = static_cast<Eigen::Index>(inputs.variables.size());
    const Dependence& dependence = inputs.dependence;
    if (dependence.kind == DependenceKind::independent) return Eigen::MatrixXd::Identity(d, d);
    if (dependence.kind == DependenceKind::pearson) {
        check_correlation(dependence.correlation, d, "pearson");
        return nataf(inputs, dependence.correlation);
    }
    check_correlation(dependence.correlation, d, "spearman");
    Eigen::MatrixXd rho_z = dependence.correlation.unaryExpr(&normal_correlation_of_ranks);
    rho_z.diagonal().setOnes(); // 2 sin(pi / 6) is 1 but for rounding
    check_correlation(rho_z, d, "spearman, seen on the normal axis");
    return rho_z;
}

void to_physical(const JointDistribution& j, Eigen::MatrixXd& u)
{
    for (Eigen::Index k = 0; k < u.cols(); ++k)
        to_quantiles(j.marginals[index(k)], {u.col(k).data(), index(u.rows())});
}

/// Rows of each size reordered among themselves.
Eigen::MatrixXd correlated_latin(const JointDistribution& j, const Design& design)
{
    Eigen::MatrixXd u = unit_cube(design);
    Eigen::Index before = 0;
    for (const std::int64_t n : design.sizes) {
        const Eigen::MatrixXd block = u.middleRows(before, n - before);
        u.middleRows(before, n - before) = reordered(block, j.rho_z, normal_scores(block));
        before = n;
    }
    return u;
}

} // namespace

JointDistribution joint_distribution(const Inputs& inputs)
{
    check_marginals(inputs);
    JointDistribution j;
    for (const Variable& v : inputs.variables) j.marginals.push_back(v.marginal);
    j.rho_z = normal_correlations(inputs);
    j.factor = Eigen::LLT<Eigen::MatrixXd>(j.rho_z).matrixL();
    j.independent = j.rho_z.isIdentity(0.0);
    return j;
}

Eigen::VectorXd from_standard_normal(const JointDistribution& j, const Eigen::VectorXd& z)
{
    Eigen::VectorXd x = j.independent ? z : j.factor.triangularView<Eigen::Lower>() * z;
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = from_normal(j.marginals[index(i)], x[i]);
    return x;
}

Eigen::MatrixXd sample(const JointDistribution& j, const Design& design)
{
    check(design);
    return sample(j, design, 0, rows(design));
}

Eigen::MatrixXd sample(const JointDistribution& j, const Design& design, std::int64_t first,
                       std::int64_t last)
{
    if (design.d != size(j))
        throw std::invalid_argument("design: variables are " + std::to_string(design.d) +
                                    "; the inputs have " + std::to_string(size(j)));
    check(design, first, last);
    if (!j.independent && is_latin(design.kind)) {
        Eigen::MatrixXd x = correlated_latin(j, design).middleRows(first, last - first);
        to_physical(j, x);
        return x;
    }
    Eigen::MatrixXd x = unit_cube(design, first, last);
    if (j.independent) {
        to_physical(j, x);
        return x;
    }
    to_normal_quantiles({x.data(), index(x.size())});
    for (Eigen::Index i = 0; i < x.rows(); ++i)
        x.row(i) = from_standard_normal(j, x.row(i).transpose()).transpose();
    return x;
}

} // namespace uq
