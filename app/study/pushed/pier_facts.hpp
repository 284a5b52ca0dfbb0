#pragma once
/// Facts of the piers and spandrels of a pushed wall. They do not depend on the rules of
/// [fragility]: the file of a study keeps them, and pier_reading.hpp reads them.

#include "app/study/pushed/pier_history.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/scene/mechanism/piers.hpp"

#include <vector>

namespace app {

struct LoadInput;

struct PushedWall;

/// Forces and movements count in the direction of the push.
struct PierFacts {
    double normal_before = 0.0;  ///< compression before the push [N]
    double normal_at_peak = 0.0; ///< when the wall carries most [N]; forces are calmed()
    double shear_at_peak = 0.0;  ///< the same
    double most_shear = 0.0;     ///< in the push [N]
    double end_movement = 0.0;   ///< at the end of the push [m]
    double slenderness =
        0.0; ///< H0 / D where it carries most: M / (V D) at the end with the larger moment [-]
    double moved = 0.0; ///< 1, or 0: it stands still and has no mode
    /// Its own blocks, as mechanism() tells them over its own height, where its own shear has
    /// come down to fragility.ultimate_share of its largest; where it keeps its shear, as the
    /// wall is read.
    dem::Mechanism mechanism;
    /// At the points of the wall's curve, of single precision: movement of its upper end
    /// against its lower end [m], and shear [N].
    std::vector<double> movement, shear;
};

/// Facts of a spandrel, cut in the middle of its opening.
struct SpandrelFacts {
    double normal_at_peak = 0.0; ///< compression when the wall carries most [N]
    double shear_at_peak = 0.0;  ///< by how much its right half presses its left half down [N]
    double most_shear = 0.0;     ///< in the push, in either sense [N], >= 0
    double end_drop = 0.0; ///< of its right end against its left end, downwards, at the end [m]
};
[[nodiscard]] std::vector<SpandrelFacts> spandrel_facts(const PierHistory& history,
                                                        const PierHistory& calm);

/// @param drop as PushPlan::drop
/// @param history of at least two points
/// @param moved by which the mode of the wall is read, and that of piers that keep their shear
[[nodiscard]] std::vector<PierFacts> pier_facts(const LoadInput& load, double drop,
                                                const dem::PierProbe& probe,
                                                const PierHistory& history,
                                                const PierHistory& calm, const PushedWall& wall,
                                                const dem::Snapshot& moved);

} // namespace app
