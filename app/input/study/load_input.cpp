#include "app/input/study/load_input.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace app {
namespace {

/// Displacements of a push to the right.
std::vector<double> right_targets(const LoadInput& load)
{
    if (!load.targets.empty()) return load.targets;
    std::vector<dem::CyclicStage> stages = dem::stages_of(load.protocol, load.max_displacement);
    if (!load.amplitudes.empty()) stages.clear();
    for (const double a : load.amplitudes) stages.push_back({a, load.repeats});
    return stages.empty() ? std::vector{load.max_displacement} : dem::cyclic_targets(stages);
}

} // namespace

StressLevel stress_level(const LoadInput& load, int level)
{
    return {level, load.vertical_stress.at(static_cast<std::size_t>(level))};
}

dem::Loads loads(const LoadInput& load, int level)
{
    return {load.vertical_stress.at(static_cast<std::size_t>(level)),
            load.height,
            load.gravity,
            load.top,
            load.link_length,
            load.pattern};
}

std::vector<double> push_targets(const LoadInput& load)
{
    std::vector<double> targets = right_targets(load);
    if (load.direction == Direction::left)
        for (double& t : targets) t = -t;
    return targets;
}

PushWay push_way(const LoadInput& load)
{
    PushWay way;
    bool right = false, left = false;
    double from = 0.0, before = 0.0;
    for (const double to : push_targets(load)) {
        (to > from ? right : left) = true;
        way.turns += before * (to - from) < 0.0 ? 1 : 0;
        before = to - from;
        way.farthest = std::max(way.farthest, std::abs(to));
        way.length += std::abs(to - from);
        from = to;
    }
    way.direction = right && left ? 0 : left ? -1 : 1;
    return way;
}

} // namespace app
