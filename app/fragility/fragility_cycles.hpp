#pragma once
/// Cycles of a study whose push turns back: damping and stiffness against drift, by stress and
/// mode.

#include "app/fragility/fragility_means.hpp"
#include "app/fragility/numbers/fragility_output.hpp"
#include "app/output/table/table.hpp"
#include "app/study/stored/study_walls.hpp"

#include <cstddef>
#include <vector>

namespace app {

/// One cycle of the protocol: means over the walls of a group that closed it.
struct CyclePoint {
    std::size_t cycle = 1; ///< from 1
    std::size_t walls = 0; ///< > 0
    double drift = 0.0;    ///< mean amplitude over the height [%]
    MeanOf damping;        ///< equivalent viscous [%]
    MeanOf stiffness;      ///< secant, as a share of that of the first cycle [-]
    MeanOf residual;       ///< half width of the loop at zero force, over the height [%]
    double energy = 0.0;   ///< mean [J]
};

/// @param mode one of modes_of(), or kAllModes
[[nodiscard]] std::vector<CyclePoint> cycle_points(const StudyWalls& walls,
                                                   const StudyLevel& level, int mode);

/// Both empty for a push that goes one way.
[[nodiscard]] Table cycle_table(const StudyWalls& walls);
[[nodiscard]] std::vector<NamedPicture> cycle_pictures(const StudyWalls& walls);

} // namespace app
