#include "dem/solver/stop_rules.hpp"

#include <algorithm>

namespace dem {

StopRule stop_below(double share, int direction)
{
    return [share, direction](std::span<const CurvePoint> curve) {
        double peak = 0.0;
        for (const CurvePoint& p : curve) peak = std::max(peak, direction * p.force);
        return curve.size() > 1 && peak > 0.0 && direction * curve.back().force < share * peak;
    };
}

StopRule at_zero_force(int direction)
{
    return [direction](std::span<const CurvePoint> curve) {
        if (direction * curve.back().force > 0.0) return false;
        return std::ranges::any_of(
            curve, [=](const CurvePoint& p) { return direction * p.force > 0.0; });
    };
}

} // namespace dem
