#pragma once
/// Sites the tests of fields share.

#include "uq/designs/stream.hpp"
#include "uq/fields/kernel.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace scenes {

/// nx x nz sites, `dx` and `dz` apart; two sites beside each other are one unit, a row a
/// course.
inline std::vector<uq::Site> grid(int nx, int nz, double dx, double dz)
{
    std::vector<uq::Site> sites;
    for (int k = 0; k < nz; ++k)
        for (int i = 0; i < nx; ++i) sites.push_back({i * dx, k * dz, (k * nx + i) / 2, k});
    return sites;
}

/// As many as the joints of the paper's wall: 180.
inline std::vector<uq::Site> wall_grid() { return grid(15, 12, 0.25, 0.20); }

/// One value of its own at every site, the paper's spatial analysis.
inline uq::Kernel independent_sites() { return {{uq::GroupCorrelation{uq::Group::all, 0.0}}}; }
/// One value for all sites, the paper's non-spatial analysis.
inline uq::Kernel one_for_all() { return {{uq::GroupCorrelation{uq::Group::all, 1.0}}}; }

/// Standard normal coordinates of samples 0 .. n - 1, each read off its own stream.
inline Eigen::MatrixXd coordinates(std::uint64_t seed, Eigen::Index n, Eigen::Index count)
{
    Eigen::MatrixXd z(n, count);
    for (Eigen::Index i = 0; i < n; ++i) {
        uq::Stream stream(seed, static_cast<std::uint64_t>(i), uq::Purpose::field);
        for (Eigen::Index j = 0; j < count; ++j) z(i, j) = stream.normal();
    }
    return z;
}

} // namespace scenes
