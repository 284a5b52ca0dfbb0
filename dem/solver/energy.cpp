#include "dem/solver/energy.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

double Energy::residual() const
{
    const double found = kinetic + elastic + friction + fracture + crushing + damping;
    const double scale = std::max(found, std::abs(work)) + lifted;
    return scale == 0.0 ? 0.0 : (work - found) / scale; // NaN stays NaN
}

} // namespace dem
