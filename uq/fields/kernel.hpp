#pragma once
/// Correlation between the sites of a random field.
///
/// d = distance of the two centres [m]. Conventions differ: OpenTURNS and Rasmussen and
/// Williams (2006, eq. 4.9) write the squared exponential with exp(-d^2 / (2 l^2)), here l = L
/// / sqrt(2); the "scale of fluctuation" of Vanmarcke (1983) is 2 L for the exponential and
/// sqrt(pi) L for the squared exponential.

#include "uq/fields/field_site.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace uq {

/// exp(-d / L); length L > 0 [m]
struct Exponential {
    double length;
};
/// exp(-(d / L)^2); L > 0 [m]
struct SquaredExponential {
    double length;
};
/// exp(-|dx| / Lx - |dz| / Lz); both > 0 [m]. OpenTURNS: AbsoluteExponential
struct ExponentialL1 {
    double length_x, length_z;
};
/// s = sqrt(2 nu) d / L: 2^(1 - nu) / Gamma(nu) s^nu K_nu(s) (Rasmussen and Williams 2006, eq.
/// 4.14); nu in [0.05, 50], L > 0 [m]. nu = 1/2 is the exponential; nu -> infinity exp(-d^2 /
/// (2 L^2)).
struct Matern {
    double nu, length;
};
enum class Group { unit, course, all };
/// `correlation` [-], in [0, 1], between two sites of one group, 0 between groups.
struct GroupCorrelation {
    Group group;
    double correlation;
};

using KernelFactor =
    std::variant<Exponential, SquaredExponential, ExponentialL1, Matern, GroupCorrelation>;

/// The product of its factors, at least one. The site with itself: 1, always.
struct Kernel {
    std::vector<KernelFactor> factors;
};

/// @throws std::invalid_argument naming the parameter that is out of range
void check(const Kernel& kernel);

/// Between two different sites, in [0, 1].
[[nodiscard]] double correlation(const Kernel& kernel, const Site& a, const Site& b);

/// Symmetric, ones on the diagonal, positive semidefinite up to rounding.
/// @throws std::invalid_argument as check, or if a coordinate is not finite or there is no site
[[nodiscard]] Eigen::MatrixXd correlation_matrix(const Kernel& kernel,
                                                 std::span<const Site> sites);

} // namespace uq
