#pragma once
/// Plane-stress zones of a rectangular block: four-node elements with incompatible bending
/// modes. Taylor, Beresford, Wilson (1976), Int. J. Numer. Meth. Eng. 10:1211 (QM6). On
/// rectangles they pass the patch test and bend exactly, so few zones are enough. The
/// constant-strain tetrahedra of the paper need many more.

#include "dem/scene/wall.hpp"

#include <Eigen/Dense>

#include <vector>

namespace dem {

/// A grid of zones. Node n = j * x.size() + i sits at (x[i], z[j]); its degrees of freedom are
/// 2n (x) and 2n + 1 (z).
struct ZoneGrid {
    std::vector<double> x; ///< [m], increasing, at least two
    std::vector<double> z; ///< [m], increasing, at least two
    [[nodiscard]] int nodes() const { return static_cast<int>(x.size() * z.size()); }
    [[nodiscard]] int node(int i, int j) const { return j * static_cast<int>(x.size()) + i; }
};

/// Stress-strain matrix (sigma_x, sigma_z, tau) from (eps_x, eps_z, gamma), plane stress [Pa].
[[nodiscard]] Eigen::Matrix3d plane_stress(const Elastic& material);

/// Stiffness of one zone [N/m], nodes counter-clockwise from the lower left.
[[nodiscard]] Eigen::Matrix<double, 8, 8>
zone_stiffness(double width, double height, double thickness, const Elastic& material);

} // namespace dem
