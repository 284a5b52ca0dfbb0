#pragma once
/// Sites the tests of fields share.

#include "uq/fields/kernel.hpp"

#include <vector>

namespace scenes {

/// nx x nz sites, `dx` and `dz` apart; two sites beside each other are one unit, a row a course.
inline std::vector<uq::Site> grid(int nx, int nz, double dx, double dz)
{
    std::vector<uq::Site> sites;
    for (int k = 0; k < nz; ++k)
        for (int i = 0; i < nx; ++i) sites.push_back({i * dx, k * dz, (k * nx + i) / 2, k});
    return sites;
}

/// As many as the joints of the paper's wall: 180.
inline std::vector<uq::Site> wall_grid() { return grid(15, 12, 0.25, 0.20); }

} // namespace scenes
