#include "uq/designs/iman_conover.hpp"

#include "core/matrix_factors.hpp"
#include "core/normal.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace uq {
namespace {

/// Rows in ascending order of their entries; equal ones in the order of the rows.
std::vector<Eigen::Index> order(const Eigen::Ref<const Eigen::VectorXd>& x)
{
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(x.size()));
    std::iota(rows.begin(), rows.end(), 0);
    std::ranges::stable_sort(rows, {}, [&](Eigen::Index i) { return x[i]; });
    return rows;
}

[[noreturn]] void refuse(Eigen::Index n, Eigen::Index d)
{
    throw std::invalid_argument("rank correlation: " + std::to_string(n) + " rows of " +
                                std::to_string(d) +
                                " variables; allowed: more rows than variables, in independent "
                                "orders (take more, or another seed)");
}

} // namespace

Eigen::MatrixXd normal_scores(const Eigen::MatrixXd& x)
{
    Eigen::MatrixXd scores(x.rows(), x.cols());
    const auto n = static_cast<double>(x.rows());
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
        double rank = 0.0;
        for (const Eigen::Index i : order(x.col(j)))
            scores(i, j) = core::normal_quantile(++rank / (n + 1.0));
    }
    return scores;
}

Eigen::MatrixXd reordered(const Eigen::MatrixXd& x, const Eigen::MatrixXd& target,
                          const Eigen::MatrixXd& scores)
{
    constexpr double kIndependent = 1e-8; // pivots of the Cholesky factor against the largest
    const auto n = static_cast<double>(x.rows());
    if (x.rows() <= x.cols()) refuse(x.rows(), x.cols());
    const Eigen::MatrixXd present = scores.transpose() * scores / n;
    const Eigen::LLT<Eigen::MatrixXd> have = core::cholesky(present),
                                      want = core::cholesky(target);
    const Eigen::MatrixXd f = have.matrixU(), c = want.matrixU();
    if (have.info() != Eigen::Success ||
        f.diagonal().minCoeff() < kIndependent * f.diagonal().maxCoeff())
        refuse(x.rows(), x.cols());
    if (want.info() != Eigen::Success)
        throw std::invalid_argument("rank correlation: the matrix is not positive definite");
    const Eigen::MatrixXd wanted = have.matrixU().solve<Eigen::OnTheRight>(scores) * c;
    Eigen::MatrixXd y(x.rows(), x.cols());
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
        const auto from = order(x.col(j)), to = order(wanted.col(j));
        for (std::size_t i = 0; i < from.size(); ++i) y(to[i], j) = x(from[i], j);
    }
    return y;
}

} // namespace uq
