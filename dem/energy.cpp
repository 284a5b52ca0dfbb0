#include "dem/energy.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

double Energy::residual() const
{
    const double found = kinetic + elastic + friction + fracture + damping;
    const double scale = std::max(std::abs(work), found);
    return scale > 0.0 ? (work - found) / scale : 0.0;
}

} // namespace dem
