#pragma once
/// One point of a capacity curve.

#include "dem/solver/state/energy.hpp"

namespace dem {

/// Its forces are means over the displacement since the previous point, and it stands at the
/// middle of that interval. A point at a turn is led there by the way before it.
struct CurvePoint {
    double displacement = 0.0; ///< of the load line [m]
    double force = 0.0;        ///< horizontal load [N]: work of the drive / displacement
    double base_shear = 0.0;   ///< horizontal force on the ground [N]
    double unbalance = 0.0;    ///< mean of |load - base shear| [N]
    Energy energy;             ///< at the end of the interval [J]
    double interval_end = 0.0; ///< displacement of the load line there [m]
    /// Horizontal, of the upper right corner at the end of the interval [m]; only with body
    /// forces.
    double corner = 0.0;
};

} // namespace dem
