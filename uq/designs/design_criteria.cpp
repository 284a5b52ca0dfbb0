#include "uq/designs/design_criteria.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace uq {

double minimum_distance(const Eigen::MatrixXd& u)
{
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < u.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            least = std::min(least, (u.row(i) - u.row(k)).squaredNorm());
    return std::sqrt(least);
}

double phi_p(const Eigen::MatrixXd& u, double p)
{
    const double least = minimum_distance(u);
    if (u.rows() < 2) return 0.0;
    if (least == 0.0) return std::numeric_limits<double>::infinity();
    double sum = 0.0; // of shares of the largest term, which cannot overflow
    for (Eigen::Index i = 0; i < u.rows(); ++i)
        for (Eigen::Index k = 0; k < i; ++k)
            sum += std::pow(least / (u.row(i) - u.row(k)).norm(), p);
    return std::pow(sum, 1.0 / p) / least;
}

double centred_discrepancy(const Eigen::MatrixXd& u)
{
    const auto n = static_cast<double>(u.rows());
    const Eigen::ArrayXXd c = (u.array() - 0.5).abs();
    double single = 0.0, pairs = 0.0;
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        single += (1.0 + 0.5 * c.row(i) - 0.5 * c.row(i).square()).prod();
        for (Eigen::Index k = 0; k < u.rows(); ++k)
            pairs += (1.0 + 0.5 * c.row(i) + 0.5 * c.row(k) -
                      0.5 * (u.row(i) - u.row(k)).array().abs())
                         .prod();
    }
    const double square = std::pow(13.0 / 12.0, static_cast<double>(u.cols())) -
                          2.0 / n * single + pairs / (n * n);
    return std::sqrt(std::max(0.0, square));
}

} // namespace uq
