#pragma once
/// Drift: displacement over the height that it belongs to, of a wall that of its load line.

namespace fragility {

/// [-]
constexpr double drift(double displacement, double height) { return displacement / height; }

/// [%]
constexpr double percent_drift(double displacement, double height)
{
    return 100.0 * displacement / height;
}

/// Factor that makes a drift in percent of a displacement [%/m].
constexpr double percent_per_metre(double height) { return 100.0 / height; }

} // namespace fragility
