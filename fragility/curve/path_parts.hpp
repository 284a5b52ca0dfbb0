#pragma once
/// Parts of a path to and fro between which it passes zero displacement.

#include "fragility/curve/cyclic_curve.hpp"

#include <cstddef>
#include <vector>

namespace fragility {

/// @throws std::invalid_argument if there are not as many finite displacements as finite forces
void check_path(const Path& path);

/// Value of y at x on the line through two points; y1 where they stand above each other.
[[nodiscard]] inline double between(double x0, double y0, double x1, double y1, double x)
{
    return x1 == x0 ? y1 : y0 + (y1 - y0) * (x - x0) / (x1 - x0);
}

/// A part of the path on one side of zero displacement, with the points between which it leaves
/// and comes back.
struct Excursion {
    int side = 0;
    std::size_t begin = 0, end = 0;
};

/// In the order of the path.
[[nodiscard]] std::vector<Excursion> excursions(const Path& path);

} // namespace fragility
