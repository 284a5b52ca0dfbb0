#include "dem/block/zones.hpp"

#include <array>
#include <cmath>

namespace dem {

namespace {

constexpr std::array<double, 4> kCornerXi = {-1, 1, 1, -1};
constexpr std::array<double, 4> kCornerEta = {-1, -1, 1, 1};

/// Strain-displacement matrix of a rectangle at (xi, eta): 8 compatible columns, then 4
/// incompatible ones (shapes 1 - xi^2 and 1 - eta^2 in each direction).
Eigen::Matrix<double, 3, 12> strain_matrix(double width, double height, double xi, double eta)
{
    Eigen::Matrix<double, 3, 12> b = Eigen::Matrix<double, 3, 12>::Zero();
    const auto add = [&b](int column, double dx, double dz) {
        b(0, column) = dx;
        b(2, column) = dz;
        b(1, column + 1) = dz;
        b(2, column + 1) = dx;
    };
    for (int n = 0; n < 4; ++n)
        add(2 * n, 0.5 * kCornerXi[n] * (1 + kCornerEta[n] * eta) / width,
            0.5 * kCornerEta[n] * (1 + kCornerXi[n] * xi) / height);
    add(8, -4.0 * xi / width, 0.0);
    add(10, 0.0, -4.0 * eta / height);
    return b;
}

} // namespace

Eigen::Matrix3d plane_stress(const Elastic& m)
{
    const double nu = m.poisson_ratio;
    Eigen::Matrix3d d;
    d << 1, nu, 0, nu, 1, 0, 0, 0, 0.5 * (1 - nu);
    return m.young_modulus / (1 - nu * nu) * d;
}

Eigen::Matrix<double, 8, 8> zone_stiffness(double width, double height, double thickness,
                                           const Elastic& material)
{
    const Eigen::Matrix3d d = plane_stress(material);
    const double gauss = 1.0 / std::sqrt(3.0);
    Eigen::Matrix<double, 12, 12> k = Eigen::Matrix<double, 12, 12>::Zero();
    for (const double xi : {-gauss, gauss})
        for (const double eta : {-gauss, gauss}) {
            const Eigen::Matrix<double, 3, 12> b = strain_matrix(width, height, xi, eta);
            k += 0.25 * width * height * thickness * (b.transpose() * d * b);
        }
    const Eigen::Matrix4d inner = k.bottomRightCorner<4, 4>();
    const Eigen::Matrix<double, 4, 8> across = k.bottomLeftCorner<4, 8>();
    return k.topLeftCorner<8, 8>() - across.transpose() * inner.ldlt().solve(across);
}

} // namespace dem
