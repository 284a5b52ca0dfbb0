#include "app/study/study_runner.hpp"

#include "app/input/wall/random_layouts.hpp"
#include "app/study/push_layouts.hpp"
#include "app/study/pushed/pier_columns.hpp"
#include "app/study/pushed/row_buffer.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "dem/solver/slower.hpp"

#include <utility>

namespace app {
Deal deal_of(const GeometryInput& geometry)
{
    return has_layouts(geometry) ? Deal::samples : Deal::walls;
}

namespace {

bool is_of(Shard shard, const StoreHead& head, WallKey key, Deal deal)
{
    const std::size_t levels = own_levels(head);
    key = own_key(head, key);
    const auto count = static_cast<std::size_t>(shard.count);
    // Levels begin at shards far apart: where the samples are not a multiple of the shards,
    // those that are left over are spread.
    const std::size_t begin = deal == Deal::samples ? 0 : key.level * count / levels;
    return (key.sample + begin) % count == static_cast<std::size_t>(shard.index);
}

} // namespace

std::vector<WallKey> walls_of(const StoreHead& head, Shard shard, Deal deal, Round round)
{
    std::vector<WallKey> walls;
    for (std::uint32_t sample = 0; sample < most_samples(head.levels); ++sample)
        for (std::uint32_t level = 0; level < head.levels.size(); ++level)
            if (round_of(head.levels[level]) == round && sample < head.levels[level].samples &&
                is_of(shard, head, {level, sample}, deal))
                walls.push_back({level, sample});
    return walls;
}

std::vector<WallKey> foreign_walls(const StoreHead& head, const std::vector<WallStatus>& there,
                                   Deal deal)
{
    const Shard shard{static_cast<int>(head.shard), static_cast<int>(head.shards)};
    std::vector<WallKey> foreign;
    for (const WallStatus& wall : there)
        if (!is_of(shard, head, wall.key, deal)) foreign.push_back(wall.key);
    return foreign;
}

std::vector<WallKey> pending_walls(const Store& store, Shard shard, bool rerun_failed,
                                   Deal deal, Round round)
{
    std::vector<WallKey> pending;
    for (const WallKey key : walls_of(store.head(), shard, deal, round)) {
        const auto status = store.status(key);
        if (!status || (rerun_failed && *status != kWallOk)) pending.push_back(key);
    }
    return pending;
}

PreparedStudy audit_study(PreparedStudy ready)
{
    ready.study.solver = dem::slower(ready.study.solver, kAuditSlower);
    return ready;
}

RunProgress run_walls(const PreparedStudy& ready, const SamplePlan& plan,
                      const std::vector<WallKey>& walls, int threads, Store& store,
                      const std::function<void(const RunProgress&)>& seen,
                      const FrameTaker& frames, RunProgress start)
{
    RunProgress so_far = start;
    so_far.all = walls.size();
    RowBuffer rows(store);
    PushList list;
    list.size = walls.size();
    list.wall = [&](std::size_t i) -> WantedWall {
        const int level = static_cast<int>(own_key(store.head(), walls[i]).level);
        return {level, draw(plan, level, static_cast<int>(walls[i].sample))};
    };
    list.done = [&](std::size_t i, const WallDraw& drawn, PushedWall&& wall) {
        const bool failed = dem::failed(wall.result.outcome);
        so_far.failed += failed ? 1 : 0;
        ++so_far.done;
        WallRow row = row_of(walls[i], drawn, wall);
        row.piers = pier_row(wall, store.head().piers);
        row.spandrels = spandrel_row(wall, store.head().spandrels);
        rows.add(std::move(row));
        if (frames && !failed)
            frames(walls[i], wall.reading.mode, frames_of(std::move(wall.result)));
        if (seen) seen(so_far);
    };
    try {
        push_in_layouts(
            ready,
            frames ? filmed(push_plan(ready.study), ready.study.load)
                   : bare(push_plan(ready.study)),
            list, [&](std::size_t i) { return walls[i].sample; }, threads);
    } catch (...) {
        rows.flush();
        throw;
    }
    rows.flush();
    return so_far;
}

} // namespace app
