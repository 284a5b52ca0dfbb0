#include "app/reading/points_error.hpp"

#include "dem/scene/mechanism/points_excess.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

/// The wall late in a push that is read; null: where it came down, only its peak counts.
const dem::Snapshot* later(const dem::PushResult& push)
{
    if (push.at_drop) return &*push.at_drop;
    if (push.at_farthest) return &*push.at_farthest;
    return push.outcome == dem::Outcome::lost_equilibrium ? nullptr : &push.at_end;
}

} // namespace

double points_error(const dem::PushResult& push)
{
    const double peak = std::abs(push.faces_at_peak.force);
    if (dem::failed(push.outcome) || !(peak > 0.0))
        return std::numeric_limits<double>::quiet_NaN();
    double most = std::abs(dem::points_excess(push.faces_at_peak));
    if (const dem::Snapshot* const late = later(push))
        most = std::max(most, std::abs(dem::points_excess(*late)));
    return most / peak;
}

} // namespace app
