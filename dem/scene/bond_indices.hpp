#pragma once
/// How well the stones of a wall are interlocked, by indices that people use. docs/theory.md,
/// section "Scenes".

#include "dem/scene/layout.hpp"

namespace dem {

/// NaN: not defined for this wall.
struct BondIndices {
    /// Length of the shortest way from the floor to the top through joints alone [m]; ways
    /// along the floor or the beam are not needed. NaN where there is none.
    double trace = 0.0;
    double trace_ratio = 0.0; ///< to the height of the wall [-], >= 1
    /// The same from the left end of the wall to the right, to the length of the wall [-], >=
    /// 1.
    double level_trace_ratio = 0.0;
    /// Distance of a head joint to the nearest one that begins where it ends, in the course
    /// above, over the mean height of a unit [-]. NaN unless all blocks are rectangles.
    double least_overlap = 0.0, mean_overlap = 0.0;
    double mean_length = 0.0, mean_height = 0.0; ///< of the units, of their extents [m]
};

/// @param layout whose blocks are whole units: laid out without potential cracks
/// @throws std::invalid_argument if it has cracks, or no unit
[[nodiscard]] BondIndices bond_indices(const Layout& layout);

} // namespace dem
