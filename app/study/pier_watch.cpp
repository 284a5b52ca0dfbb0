#include "app/study/pier_watch.hpp"

#include "app/input/wall_geometry.hpp"
#include "app/study/wall_openings.hpp"

#include <cmath>
#include <utility>

namespace app {

PierWatch::PierWatch(const Study& study, const dem::Layout& layout, std::size_t walls,
                     dem::PushPlan& plan)
    : study_(study), walls_(walls)
{
    if (!tells_piers(study)) return;
    probe_.emplace(layout, dem::piers_of(wall_openings(study), wall_extent(study)));
    const double every = plan.snapshot_every;
    plan.snapshot_every = plan.record_every;
    plan.mean_stresses = true;
    plan.sink = {
        .take =
            [this, every, next = plan.sink.take](std::size_t wall, dem::Snapshot&& shot) {
                look(wall, shot);
                constexpr double kRounding = 1e-9; // as dem/solver/wall_run.cpp
                Watched& w = walls_.at(wall);
                if (every <= 0.0 || std::abs(shot.displacement) < w.next * (1.0 - kRounding))
                    return;
                w.next += every;
                if (next)
                    next(wall, std::move(shot));
                else
                    w.kept.push_back(std::move(shot));
            },
        .forget =
            [this, next = plan.sink.forget](std::size_t wall) {
                walls_.at(wall) = {};
                if (next) next(wall);
            }};
}

void PierWatch::look(std::size_t wall, const dem::Snapshot& shot)
{
    walls_.at(wall).history.push_back(pier_instant(*probe_, shot));
}

void PierWatch::add_to(std::size_t wall, PushedWall& pushed)
{
    if (!probe_) return;
    pushed.result.snapshots = std::move(walls_.at(wall).kept);
    read_piers(study_, *probe_, walls_.at(wall).history, pushed);
}

} // namespace app
