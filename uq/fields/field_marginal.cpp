#include "uq/fields/field_marginal.hpp"

namespace uq {

Eigen::MatrixXd translate(const Eigen::MatrixXd& standard, const Marginal& m)
{
    return standard.unaryExpr([&m](double g) { return from_normal(m, g); });
}

} // namespace uq
