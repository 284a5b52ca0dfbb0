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

} // namespace uq
