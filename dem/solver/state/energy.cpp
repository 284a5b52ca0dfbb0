#include "dem/solver/state/energy.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

namespace {

double found(const Energy& e)
{
    return e.kinetic + e.elastic + e.friction + e.fracture + e.crushing + e.damping;
}

} // namespace

double Energy::passed() const
{
    return std::max(found(*this), std::abs(work)) +
           (lifted < 0.0 ? 0.0 : lifted); // NaN stays NaN
}

double Energy::residual() const
{
    const double scale = passed();
    return scale == 0.0 ? 0.0 : (work - found(*this)) / scale; // NaN stays NaN
}

} // namespace dem
