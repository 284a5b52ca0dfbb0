#pragma once
/// Forces and movements of piers and spandrels at the points of a curve.

#include "dem/scene/mechanism/piers.hpp"

#include <cstddef>
#include <vector>

namespace app {

/// Piers and spandrels at one curve point.
struct PierInstant {
    double displacement = 0.0, force = 0.0; ///< of the load line [m] [N]
    double base_shear = 0.0;                ///< mean since the point before, as all forces [N]
    std::vector<dem::PierState> piers; ///< in the order of dem::Piers; movements are of now
    std::vector<dem::SpandrelState> spandrels;
};
using PierHistory = std::vector<PierInstant>;
[[nodiscard]] PierInstant pier_instant(const dem::PierProbe& probe, const dem::Snapshot& shot);

/// Way of the load line to either side over which forces of piers are means, as a share of its
/// height. A free choice: where a block slips a wall rings, and sums of piers miss the shear at
/// the base by up to 2 % at one point of the curve, by 0.5 % over some.
constexpr double kCalm = 2e-4;

/// The same with each force the mean of those of the instants within `way` [m], as many to
/// either side. Movements are left.
[[nodiscard]] PierHistory calmed(const PierHistory& history, double way);

/// The instant at which the wall carries most.
[[nodiscard]] std::size_t at_peak(const PierHistory& history);

} // namespace app
