#include "dem/shaking/shaking_clock.hpp"

#include <cmath>
#include <cstddef>

namespace dem {

ShakingClock shaking_clock(const ShakePlan& plan, double most)
{
    ShakingClock clock;
    clock.substeps = static_cast<long long>(std::ceil(plan.step / most));
    clock.dt = plan.step / static_cast<double>(clock.substeps);
    if (!plan.horizontal.empty())
        clock.record = static_cast<long long>(plan.horizontal.size() - 1) * clock.substeps;
    clock.last = clock.record + std::llround(plan.free_vibration / clock.dt);
    return clock;
}

double ground_now(const std::vector<double>& a, const ShakingClock& clock)
{
    const auto at = static_cast<std::size_t>(clock.step / clock.substeps);
    if (at >= a.size()) return 0.0;
    const double part =
        static_cast<double>(clock.step % clock.substeps) / static_cast<double>(clock.substeps);
    if (at + 1 < a.size()) return a[at] + part * (a[at + 1] - a[at]);
    return part == 0.0 ? a[at] : 0.0;
}

} // namespace dem
