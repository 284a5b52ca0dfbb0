#include "fragility/curve/state_parts.hpp"

#include <algorithm>

namespace fragility {
namespace {

LimitDisplacement reached(double known, double cap, std::string_view governs)
{
    if (known >= cap) return {cap, Reading::observed, governs};
    return {known, Reading::censored, "the curve ends before"};
}

} // namespace

LimitDisplacement rise_to(const Curve& curve, double share)
{
    const Peak top = peak(curve);
    const auto at = first_reaching(curve, share * top.force);
    if (top.force <= 0.0 || !at)
        return {0.0, Reading::not_defined, "the force is never positive"};
    if (top.at_end)
        return {*at, Reading::observed, "of the highest force so far: the curve still rises"};
    return {*at, Reading::observed, {}};
}

LimitDisplacement at_peak(const Peak& top)
{
    if (top.at_end) return {top.displacement, Reading::censored, "the curve still rises"};
    return {top.displacement, Reading::observed, {}};
}

LimitDisplacement cap_alone(const Curve& curve, double cap, std::string_view governs)
{
    return reached(curve.displacement.back(), cap, governs);
}

LimitDisplacement capped(const Curve& curve, const LimitDisplacement& limit, double cap,
                         std::string_view governs)
{
    if (limit.reading == Reading::not_defined) return limit;
    if (limit.reading == Reading::observed && limit.displacement <= cap) return limit;
    return reached(std::max(limit.displacement, curve.displacement.back()), cap, governs);
}

} // namespace fragility
