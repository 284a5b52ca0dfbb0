#include "app/study/pushed/pier_watch.hpp"

#include "app/input/study/load_input.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/study/pushed/wall_openings.hpp"

#include <cmath>
#include <utility>

namespace app {

PierWatch::PierWatch(const Masonry& masonry, const LoadInput& load, PierRules rules,
                     const dem::Layout& layout, dem::PushPlan& plan)
    : load_(load), rules_(std::move(rules)), drop_(plan.drop)
{
    if (!tells_piers(masonry, load)) return;
    probe_.emplace(layout, dem::piers_of(wall_openings(masonry), wall_extent(masonry)));
    const double every = plan.snapshot_every;
    plan.snapshot_every = plan.record_every;
    plan.mean_stresses = true;
    plan.sink = {
        .take =
            [this, every, next = plan.sink.take](std::size_t wall, dem::Snapshot&& shot) {
                Watched& w = watched(wall);
                w.history.push_back(instant(w, shot));
                constexpr double kRounding = 1e-9; // as dem/solver/wall_run.cpp
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
                watched(wall) = {};
                if (next) next(wall);
            }};
}

/// Movements are looked at as often as forces are calmed.
PierInstant PierWatch::instant(Watched& w, const dem::Snapshot& shot) const
{
    PierInstant now = pier_instant(*probe_, shot);
    if (std::abs(shot.displacement) < w.look) return now;
    w.look = std::abs(shot.displacement) + kCalm * load_.height;
    for (std::size_t i = 0; i < probe_->piers().piers.size(); ++i)
        now.movements.push_back(pier_movement(*probe_, i, shot));
    return now;
}

PierWatch::Watched& PierWatch::watched(std::size_t wall)
{
    const std::lock_guard lock(mutex_);
    return walls_[wall];
}

void PierWatch::add_to(std::size_t wall, PushedWall& pushed)
{
    if (!probe_) return;
    Watched w;
    {
        const std::lock_guard lock(mutex_);
        if (auto known = walls_.extract(wall)) w = std::move(known.mapped());
    }
    pushed.result.snapshots = std::move(w.kept);
    read_piers(rules_, load_, drop_, *probe_, w.history, pushed);
}

} // namespace app
