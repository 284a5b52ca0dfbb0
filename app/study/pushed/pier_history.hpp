#pragma once
/// Forces and movements of piers and spandrels at the points of a curve.

#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/scene/mechanism/piers.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace app {

/// How a pier has moved.
struct PierMovement {
    bool moved = false; ///< else it stands still, and has no mode
    dem::Mechanism
        mechanism; ///< of its own blocks, as mechanism() tells them over its own height
};
[[nodiscard]] PierMovement pier_movement(const dem::PierProbe& probe, std::size_t pier,
                                         const dem::Snapshot& shot);

/// Piers and spandrels at one curve point.
struct PierInstant {
    double displacement = 0.0, force = 0.0; ///< of the load line [m] [N]
    double base_shear = 0.0;                ///< mean since the point before, as all forces [N]
    std::vector<dem::PierState> piers; ///< in the order of dem::Piers; movements are of now
    std::vector<dem::SpandrelState> spandrels;
    std::vector<PierMovement> movements; ///< of all piers; empty: nobody looked
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

/// The movement of a pier where its own shear has come down to a share of its largest, as the
/// mode of a wall is read where its force has; nothing where it keeps its shear, or has not
/// moved by then.
/// @param way 1: the push goes to the right, -1: to the left
/// @param share in [0, 1); 0: nothing
[[nodiscard]] std::optional<PierMovement>
movement_at_drop(const PierHistory& calm, std::size_t pier, double way, double share);

} // namespace app
