#pragma once
/// The capacity curve as a table.

#include <span>
#include <string>
#include <vector>

namespace app {

/// A further column.
struct CurveColumn {
    std::string name;           ///< with its unit: "base_shear_kN"
    std::vector<double> values; ///< in that unit, by point
};

/// "displacement_mm,drift_percent,force_kN" and `more`, one row per point, 9 significant
/// digits; an empty cell where a value is not finite. Throws std::invalid_argument if the
/// lengths differ or the height is not positive.
/// @param displacement of the load line, or of the wall's centre of gravity [m]
/// @param force horizontal load [N]
/// @param height drift = displacement / height [m], > 0
[[nodiscard]] std::string capacity_csv(std::span<const double> displacement,
                                       std::span<const double> force, double height,
                                       const std::vector<CurveColumn>& more = {});

} // namespace app
