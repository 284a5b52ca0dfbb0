#include "app/study/pushed/wall_frames.hpp"

#include "app/input/study/study.hpp"

#include <algorithm>
#include <utility>

namespace app {

dem::PushPlan bare(dem::PushPlan plan)
{
    plan.snapshot_every = 0.0;
    plan.snapshot_at_peak = false;
    return plan;
}

int film_frames(const LoadInput& load)
{
    if (push_way(load).direction != 0) return kFilmFrames;
    const auto ways = static_cast<int>(push_targets(load).size());
    return std::clamp(ways * kFramesOfAWay, kFilmFrames, kMostFilmFrames);
}

double film_step(const LoadInput& load) { return push_way(load).length / film_frames(load); }

dem::PushPlan filmed(dem::PushPlan plan, const LoadInput& load)
{
    plan = bare(std::move(plan));
    plan.snapshot_every = film_step(load);
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
