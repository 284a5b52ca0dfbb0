#include "uq/fields/field.hpp"

#include "core/row_products.hpp"

#include <stdexcept>
#include <string>

namespace uq {

namespace {

void check_coordinates(const Eigen::MatrixXd& z, Eigen::Index needed)
{
    if (z.cols() != needed)
        throw std::invalid_argument("the field has " + std::to_string(needed) +
                                    " coordinates, got " + std::to_string(z.cols()));
    if (!z.allFinite()) throw std::invalid_argument("a coordinate of the field is not finite");
}

} // namespace

Eigen::MatrixXd realise(const FieldBasis& basis, const Eigen::MatrixXd& z)
{
    check_coordinates(z, basis.map.cols());
    return core::times_transposed(z, basis.map);
}

} // namespace uq
