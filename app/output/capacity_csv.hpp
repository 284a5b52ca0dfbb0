#pragma once
/// The capacity curve as a table.

#include <span>
#include <string>
#include <vector>

namespace app {

/// Further columns of a wall that body forces push.
struct BodyForceColumns {
    std::vector<double>
        load_factor; ///< body force over weight [-], by point; empty: no such columns
    std::vector<double> corner; ///< horizontal displacement of the upper right corner [m]
};

/// "displacement_mm,drift_percent,force_kN" and one row per point, with "load_factor,
/// corner_displacement_mm" of body forces, 9 significant digits; an
/// empty cell where a value is not finite. Throws std::invalid_argument if the lengths differ
/// or the height is not positive.
/// @param displacement of the load line, or of the wall's centre of gravity [m]
/// @param force horizontal load [N]
/// @param height drift = displacement / height [m], > 0
[[nodiscard]] std::string capacity_csv(std::span<const double> displacement,
                                       std::span<const double> force, double height,
                                       const BodyForceColumns& body = {});

} // namespace app
