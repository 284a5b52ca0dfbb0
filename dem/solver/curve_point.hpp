#pragma once
/// One point of a capacity curve.

#include "dem/solver/energy.hpp"

namespace dem {

/// A point of the capacity curve: means over the way since the previous point, placed at its
/// middle.
struct CurvePoint {
    double displacement = 0.0; ///< of the load line [m]
    double force = 0.0;        ///< horizontal load [N]: work of the drive / way
    double base_shear = 0.0;   ///< horizontal force on the ground [N]
    double unbalance = 0.0;    ///< mean of |load - base shear| [N]
    Energy
        energy; ///< at the end of the interval, since the unloaded wall [J]; zeros if not kept
};

} // namespace dem
