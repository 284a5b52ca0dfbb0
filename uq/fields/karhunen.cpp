#include "uq/fields/karhunen.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

struct Modes {
    Eigen::VectorXd values;  ///< descending
    Eigen::MatrixXd vectors; ///< columns
};

/// The largest entry of a mode decides its sign: eigenvectors have none of their own.
void fix_signs(Eigen::MatrixXd& vectors)
{
    for (auto v : vectors.colwise()) {
        Eigen::Index largest = 0;
        v.cwiseAbs().maxCoeff(&largest);
        if (v[largest] < 0.0) v = -v;
    }
}

Modes modes_of(const Eigen::MatrixXd& r, bool with_vectors)
{
    const Eigen::Index p = r.rows();
    if (r.isDiagonal(0.0)) return {Eigen::VectorXd::Ones(p), Eigen::MatrixXd::Identity(p, p)};
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        r, with_vectors ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
    if (solver.info() != Eigen::Success)
        throw std::invalid_argument("the eigenvalues of the correlation matrix were not found");
    if (solver.eigenvalues()[0] < -kLargestNugget)
        throw std::invalid_argument("the correlation matrix has the eigenvalue " +
                                    std::to_string(solver.eigenvalues()[0]) + ", must be >= 0");
    Modes modes{solver.eigenvalues().reverse().cwiseMax(0.0), {}};
    if (with_vectors) {
        modes.vectors = solver.eigenvectors().rowwise().reverse();
        fix_signs(modes.vectors);
    }
    return modes;
}

void report_dropped(FieldBasis& basis)
{
    const Eigen::VectorXd dropped =
        (1.0 - basis.map.rowwise().squaredNorm().array()).cwiseMax(0.0);
    basis.dropped = dropped.mean();
    basis.worst_dropped = dropped.maxCoeff(&basis.worst_site);
}

void restore_variance(FieldBasis& basis)
{
    for (Eigen::Index i = 0; i < basis.map.rows(); ++i) {
        const double norm = basis.map.row(i).norm();
        if (norm < 1e-6)
            throw std::invalid_argument("site " + std::to_string(i) +
                                        " has no variance left in the modes kept: keep more");
        if (norm != 1.0) basis.map.row(i) /= norm;
    }
}

} // namespace

Eigen::VectorXd karhunen_eigenvalues(const Eigen::MatrixXd& correlation)
{
    static_cast<void>(distinct_sites(correlation)); // checks the matrix
    return modes_of(correlation, false).values;
}

Eigen::Index modes_for(const Eigen::VectorXd& eigenvalues, double share)
{
    if (!(share > 0.0 && share <= 1.0))
        throw std::invalid_argument("share of the variance is " + std::to_string(share) +
                                    ", must be in (0, 1]");
    const double total = eigenvalues.sum();
    double kept = 0.0;
    for (Eigen::Index k = 0; k < eigenvalues.size(); ++k) {
        kept += eigenvalues[k];
        if (kept >= share * total) return k + 1;
    }
    return eigenvalues.size();
}

FieldBasis karhunen_basis(const Eigen::MatrixXd& correlation, const KarhunenOptions& options)
{
    const DistinctSites sites = distinct_sites(correlation);
    const Modes modes = modes_of(reduced(correlation, sites), true);
    const Eigen::Index all = modes.values.size();
    if (options.modes < 0 || options.modes > all)
        throw std::invalid_argument("number of modes is " + std::to_string(options.modes) +
                                    ", must be in 0 .. " + std::to_string(all));
    const Eigen::Index kept =
        options.modes > 0 ? options.modes : modes_for(modes.values, options.share);
    FieldBasis basis;
    basis.eigenvalues = modes.values.head(kept);
    const Eigen::MatrixXd scaled =
        modes.vectors.leftCols(kept) * basis.eigenvalues.cwiseSqrt().asDiagonal();
    basis.map = expanded(scaled, sites);
    basis.unit_variance = options.unit_variance;
    report_dropped(basis);
    if (options.unit_variance) restore_variance(basis);
    return basis;
}

} // namespace uq
