#include "uq/fields/field.hpp"

#include "uq/designs/stream.hpp"
#include "uq/fields/field_product.hpp"
#include "uq/marginals/normal_quantile.hpp"

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

std::span<double> entries(Eigen::MatrixXd& z)
{
    return {z.data(), static_cast<std::size_t>(z.size())};
}

} // namespace

Eigen::MatrixXd field_coordinates(std::uint64_t seed, std::span<const std::uint64_t> id,
                                  Eigen::Index count)
{
    if (count < 0) throw std::invalid_argument("number of coordinates is negative");
    Eigen::MatrixXd z(static_cast<Eigen::Index>(id.size()), count);
    std::vector<double> row(static_cast<std::size_t>(count));
    for (Eigen::Index i = 0; i < z.rows(); ++i) {
        Stream stream(seed, id[static_cast<std::size_t>(i)], Purpose::field);
        stream.fill_uniform(row);
        z.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), count);
    }
    to_normal_quantiles(entries(z));
    return z;
}

Eigen::MatrixXd normal_coordinates(const Eigen::MatrixXd& unit_cube)
{
    for (Eigen::Index j = 0; j < unit_cube.cols(); ++j)
        for (Eigen::Index i = 0; i < unit_cube.rows(); ++i)
            if (!(unit_cube(i, j) > 0.0 && unit_cube(i, j) < 1.0))
                throw std::invalid_argument("entry (" + std::to_string(i) + ", " +
                                            std::to_string(j) + ") of the design is " +
                                            std::to_string(unit_cube(i, j)) +
                                            ", must be in (0, 1)");
    Eigen::MatrixXd z = unit_cube;
    to_normal_quantiles(entries(z));
    return z;
}

Eigen::MatrixXd realise(const FieldBasis& basis, const Eigen::MatrixXd& z)
{
    check_coordinates(z, basis.map.cols());
    return times_transposed(z, basis.map);
}

std::vector<Eigen::MatrixXd> realise(const FieldBasis& basis, const Eigen::MatrixXd& variables,
                                     const Eigen::MatrixXd& z)
{
    const Eigen::MatrixXd mix = cholesky_basis(variables).map; // variables x distinct variables
    const Eigen::Index r = basis.map.cols();
    check_coordinates(z, variables.rows() * r);
    std::vector<Eigen::MatrixXd> own;
    for (Eigen::Index l = 0; l < mix.cols(); ++l)
        own.push_back(times_transposed(z.middleCols(l * r, r), basis.map));
    std::vector<Eigen::MatrixXd> fields;
    for (Eigen::Index k = 0; k < mix.rows(); ++k) {
        Eigen::MatrixXd g = mix(k, 0) * own[0];
        for (Eigen::Index l = 1; l < mix.cols(); ++l)
            if (mix(k, l) != 0.0) g += mix(k, l) * own[static_cast<std::size_t>(l)];
        fields.push_back(std::move(g));
    }
    return fields;
}

} // namespace uq
