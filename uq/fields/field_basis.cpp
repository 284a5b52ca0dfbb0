#include "uq/fields/field_basis.hpp"

#include "core/matrix_factors.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

void check_entry(const Eigen::MatrixXd& r, Eigen::Index i, Eigen::Index j)
{
    const double x = r(i, j);
    const bool ok = i == j ? x == 1.0 : std::abs(x) <= 1.0 && x == r(j, i); // false for NaN
    if (!ok)
        throw std::invalid_argument("correlation (" + std::to_string(i) + ", " +
                                    std::to_string(j) + ") is " + std::to_string(x) +
                                    ", must be in [-1, 1], symmetric, and 1 on the diagonal");
}

} // namespace

DistinctSites distinct_sites(const Eigen::MatrixXd& correlation)
{
    const Eigen::Index p = correlation.rows();
    if (p == 0 || correlation.cols() != p)
        throw std::invalid_argument(
            "a correlation matrix is square with at least one row, got " + std::to_string(p) +
            " x " + std::to_string(correlation.cols()));
    DistinctSites sites;
    for (Eigen::Index i = 0; i < p; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) check_entry(correlation, i, j);
        std::size_t k = 0;
        while (k < sites.first.size() && correlation(i, sites.first[k]) != 1.0) ++k;
        if (k == sites.first.size()) sites.first.push_back(i);
        sites.of.push_back(static_cast<Eigen::Index>(k));
    }
    return sites;
}

Eigen::MatrixXd reduced(const Eigen::MatrixXd& correlation, const DistinctSites& sites)
{
    return correlation(sites.first, sites.first);
}

Eigen::MatrixXd expanded(const Eigen::MatrixXd& rows, const DistinctSites& sites)
{
    return rows(sites.of, Eigen::all);
}

FieldBasis cholesky_basis(const Eigen::MatrixXd& correlation)
{
    const DistinctSites sites = distinct_sites(correlation);
    const Eigen::MatrixXd r = reduced(correlation, sites);
    FieldBasis basis;
    Eigen::LLT<Eigen::MatrixXd> llt = core::cholesky(r);
    while (llt.info() != Eigen::Success) {
        basis.nugget = basis.nugget == 0.0 ? 1e-14 : 10.0 * basis.nugget;
        if (basis.nugget > kLargestNugget)
            throw std::invalid_argument("the correlation matrix has a negative eigenvalue");
        Eigen::MatrixXd raised = r / (1.0 + basis.nugget);
        raised.diagonal().setOnes();
        llt = core::cholesky(raised);
    }
    basis.map = expanded(llt.matrixL(), sites);
    return basis;
}

} // namespace uq
