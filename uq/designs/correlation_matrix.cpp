#include "uq/designs/correlation_matrix.hpp"

#include "core/eigen_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace uq {
namespace {

constexpr double kSymmetric = 1e-12;   // difference of mirrored entries
constexpr double kDefinite = 1e-10;    // least eigenvalue
constexpr Eigen::Index kShownRows = 8; // beyond it only what moved

/// Onto the matrices whose eigenvalues are at least `least`.
Eigen::MatrixXd lifted(const Eigen::MatrixXd& a, double least)
{
    const core::EigenPairs e = core::eigen_pairs(a);
    const Eigen::VectorXd values = e.values.cwiseMax(least);
    const Eigen::MatrixXd x = e.vectors * values.asDiagonal() * e.vectors.transpose();
    return 0.5 * (x + x.transpose());
}

double least_eigenvalue(const Eigen::MatrixXd& a) { return core::eigen_pairs(a).values[0]; }

const char* fault(const Eigen::MatrixXd& r)
{
    if ((r - r.transpose()).cwiseAbs().maxCoeff() > kSymmetric) return "is not symmetric";
    if ((r.diagonal().array() != 1.0).any()) return "is not 1 on its diagonal";
    if (r.cwiseAbs().maxCoeff() > 1.0) return "has an entry outside [-1, 1]";
    if (least_eigenvalue(r) < kDefinite) return "is not positive definite";
    return nullptr;
}

std::string moved_entries(const Eigen::MatrixXd& r, const Eigen::MatrixXd& from)
{
    struct Entry {
        Eigen::Index i, j;
    };
    std::vector<Entry> entries;
    for (Eigen::Index i = 0; i < r.rows(); ++i)
        for (Eigen::Index j = 0; j < i; ++j) entries.push_back({i, j});
    std::ranges::stable_sort(entries, std::greater<>{}, [&](const Entry& e) {
        return std::abs(r(e.i, e.j) - from(e.i, e.j));
    });
    entries.resize(std::min<std::size_t>(entries.size(), 10));
    std::ostringstream text;
    text.precision(6);
    text << "what moves most:";
    for (const Entry& e : entries)
        text << " (" << e.i + 1 << ", " << e.j + 1 << ") from " << from(e.i, e.j) << " to "
             << r(e.i, e.j) << ';';
    return text.str();
}

} // namespace

Eigen::MatrixXd nearest_correlation(const Eigen::MatrixXd& a, double least)
{
    constexpr int kSteps = 2000;
    constexpr double kStill = 1e-12;
    Eigen::MatrixXd y = 0.5 * (a + a.transpose());
    Eigen::MatrixXd correction = Eigen::MatrixXd::Zero(a.rows(), a.cols());
    for (int i = 0; i < kSteps; ++i) {
        const Eigen::MatrixXd r = y - correction;
        const Eigen::MatrixXd x = lifted(r, least);
        correction = x - r;
        y = x;
        y.diagonal().setOnes();
        if ((y - x).norm() <= kStill * y.norm()) break;
    }
    return y;
}

std::string correlation_text(const Eigen::MatrixXd& r, const Eigen::MatrixXd& from)
{
    if (r.rows() > kShownRows) return moved_entries(r, from);
    std::ostringstream text;
    text << r.format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ", ", ", "[", "]"));
    return text.str();
}

void check_correlation(const Eigen::MatrixXd& r, Eigen::Index d, const std::string& what)
{
    if (r.rows() != d || r.cols() != d)
        throw std::invalid_argument(
            what + ": the correlation matrix is " + std::to_string(r.rows()) + " x " +
            std::to_string(r.cols()) + "; allowed: " + std::to_string(d) + " x " +
            std::to_string(d) + ", as many as variables");
    if (!r.allFinite())
        throw std::invalid_argument(what + ": the correlation matrix has an entry that is not "
                                           "a finite number");
    const char* reason = fault(r);
    if (reason == nullptr) return;
    constexpr double kShown = 1e-4; // so that the matrix is one also when rounded to 6 digits
    throw std::invalid_argument(what + ": the correlation matrix " + reason + "; nearest: " +
                                correlation_text(nearest_correlation(r, kShown), r));
}

} // namespace uq
