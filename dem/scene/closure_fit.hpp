#pragma once
/// The law of closure that explains how stiff dry joints are under several pressures.

#include "dem/scene/wall.hpp"

#include <span>
#include <vector>

namespace dem {

/// Normal stiffness of a closing joint under a pressure, k_0 + p / V_m [Pa/m]. Of the hyperbola
/// it is the secant from no pressure, of the exponential the tangent.
/// @param pressure [Pa], >= 0
[[nodiscard]] double closed_stiffness(const Closing& c, double pressure);

/// Closing::stiffest over Closing::initial_stiffness, at most [-].
constexpr double kMostStiffening = 1e3;

struct ClosureFit {
    double initial_stiffness =
        0.0;              ///< k_0 [Pa/m]; <= 0 where no law of closure has these stiffnesses
    double maximum = 0.0; ///< V_m [m]; negative, or infinite, in the same case
    std::vector<double> residuals; ///< stiffness by the law over the one given, less 1 [-]
};

/// k_0 and V_m of the least sum of squares of the differences in stiffness.
/// @param stiffness normal stiffness of a joint under each pressure [Pa/m], > 0
/// @param pressure [Pa], as many, of which two at least differ
[[nodiscard]] ClosureFit fit_closure(std::span<const double> stiffness,
                                     std::span<const double> pressure);

} // namespace dem
