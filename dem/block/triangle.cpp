#include "dem/block/triangle.hpp"

#include "dem/block/zones.hpp"

namespace dem {

namespace {

/// Strains (eps_x, eps_z, gamma) from the displacements of the nodes, at area coordinates l.
Eigen::Matrix<double, 3, 12> strain_matrix(const std::array<Point, 3>& c, double area,
                                           const std::array<double, 3>& l)
{
    std::array<double, 3> dx{}, dz{}; // of the area coordinates
    for (int i = 0; i < 3; ++i) {
        const Point a = c[(i + 1) % 3], b = c[(i + 2) % 3];
        dx[i] = (a.z - b.z) / (2.0 * area);
        dz[i] = (b.x - a.x) / (2.0 * area);
    }
    Eigen::Matrix<double, 3, 12> m = Eigen::Matrix<double, 3, 12>::Zero();
    const auto add = [&m](int node, double x, double z) {
        m(0, 2 * node) = x;
        m(2, 2 * node) = z;
        m(1, 2 * node + 1) = z;
        m(2, 2 * node + 1) = x;
    };
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        add(i, (4.0 * l[i] - 1.0) * dx[i], (4.0 * l[i] - 1.0) * dz[i]);
        add(3 + i, 4.0 * (l[i] * dx[j] + l[j] * dx[i]), 4.0 * (l[i] * dz[j] + l[j] * dz[i]));
    }
    return m;
}

} // namespace

double triangle_area(const std::array<Point, 3>& c)
{
    return 0.5 *
           ((c[1].x - c[0].x) * (c[2].z - c[0].z) - (c[2].x - c[0].x) * (c[1].z - c[0].z));
}

Eigen::Matrix<double, 12, 12> triangle_stiffness(const std::array<Point, 3>& corners,
                                                 double thickness, const Elastic& material)
{
    const double area = triangle_area(corners);
    const Eigen::Matrix3d d = plane_stress(material);
    Eigen::Matrix<double, 12, 12> k = Eigen::Matrix<double, 12, 12>::Zero();
    for (int i = 0; i < 3; ++i) {
        std::array<double, 3> l{1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0};
        l[i] = 2.0 / 3.0;
        const Eigen::Matrix<double, 3, 12> b = strain_matrix(corners, area, l);
        k += area * thickness / 3.0 * (b.transpose() * d * b);
    }
    return k;
}

} // namespace dem
