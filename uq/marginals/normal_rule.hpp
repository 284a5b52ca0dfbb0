#pragma once
/// Integration against the standard normal density.

#include <vector>

namespace uq {

/// sum of weight * f(z) = integral of f(z) phi(z)
struct NormalRule {
    std::vector<double> z, weight;
};

/// Gauss-Legendre with 30 points on each of the stretches of unit length from -37 to 37, and on
/// the parts of them that `breaks` (kinks of f, any order) make.
[[nodiscard]] NormalRule normal_rule(std::vector<double> breaks = {});

} // namespace uq
