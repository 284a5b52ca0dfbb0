#include "app/study/wall_frames.hpp"

#include <cmath>
#include <utility>

namespace app {

dem::PushPlan bare_plan(const Study& study)
{
    dem::PushPlan plan = push_plan(study);
    plan.snapshot_every = 0.0;
    plan.snapshot_at_peak = false;
    plan.energy_at_points = false;
    return plan;
}

dem::PushPlan filmed_plan(const Study& study)
{
    dem::PushPlan plan = bare_plan(study);
    double way = 0.0, from = 0.0;
    for (const double to : plan.targets) {
        way += std::abs(to - from);
        from = to;
    }
    plan.snapshot_every = way / kFilmFrames;
    return plan;
}

std::vector<dem::Snapshot> frames_of(dem::PushResult&& result)
{
    std::vector<dem::Snapshot> frames = std::move(result.snapshots);
    const bool whole =
        !frames.empty() && frames.back().displacement == result.at_end.displacement;
    if (!whole) frames.push_back(std::move(result.at_end));
    return frames;
}

} // namespace app
