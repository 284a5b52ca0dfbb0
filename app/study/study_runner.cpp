#include "app/study/study_runner.hpp"

#include "app/input/random_layouts.hpp"
#include "app/output/progress.hpp"
#include "app/study/push_layouts.hpp"
#include "app/study/study_columns.hpp"

#include <utility>

namespace app {
namespace {

/// Finished walls on their way into the file. A kill loses those that wait here.
class RowBuffer {
  public:
    explicit RowBuffer(Store& store) : store_(store) {}
    void add(WallRow row)
    {
        rows_.push_back(std::move(row));
        if (rows_.size() >= kMost || steady_seconds() - last_ > kSeconds) flush();
    }
    void flush()
    {
        if (!rows_.empty()) store_.append(rows_);
        rows_.clear();
        last_ = steady_seconds();
    }

  private:
    static constexpr std::size_t kMost = 1000;
    static constexpr double kSeconds = 3.0;
    Store& store_;
    std::vector<WallRow> rows_;
    double last_ = steady_seconds();
};

} // namespace

Deal deal_of(const Study& study) { return has_layouts(study) ? Deal::samples : Deal::walls; }

namespace {

/// @param levels of the study
bool is_of(Shard shard, WallKey key, std::size_t levels, Deal deal)
{
    const auto count = static_cast<std::size_t>(shard.count);
    // Levels begin at shards far apart: where the samples are not a multiple of the shards, those
    // that are left over are spread.
    const std::size_t begin = deal == Deal::samples ? 0 : key.level * count / levels;
    return (key.sample + begin) % count == static_cast<std::size_t>(shard.index);
}

} // namespace

std::vector<WallKey> walls_of(const StoreHead& head, Shard shard, Deal deal)
{
    std::uint32_t most = 0;
    for (const StoreLevel& level : head.levels) most = std::max(most, level.samples);
    std::vector<WallKey> walls;
    for (std::uint32_t sample = 0; sample < most; ++sample)
        for (std::uint32_t level = 0; level < head.levels.size(); ++level)
            if (sample < head.levels[level].samples &&
                is_of(shard, {level, sample}, head.levels.size(), deal))
                walls.push_back({level, sample});
    return walls;
}

std::vector<WallKey> foreign_walls(const StoreHead& head, const std::vector<WallStatus>& there,
                                   Deal deal)
{
    const Shard shard{static_cast<int>(head.shard), static_cast<int>(head.shards)};
    std::vector<WallKey> foreign;
    for (const WallStatus& wall : there)
        if (!is_of(shard, wall.key, head.levels.size(), deal)) foreign.push_back(wall.key);
    return foreign;
}

std::vector<WallKey> pending_walls(const Store& store, Shard shard, bool rerun_failed,
                                   Deal deal)
{
    std::vector<WallKey> pending;
    for (const WallKey key : walls_of(store.head(), shard, deal)) {
        const auto status = store.status(key);
        if (!status || (rerun_failed && *status != kWallOk)) pending.push_back(key);
    }
    return pending;
}

RunProgress run_walls(const Study& study, const SamplePlan& plan,
                      const std::vector<WallKey>& walls, int threads, Store& store,
                      const std::function<void(const RunProgress&)>& seen,
                      const FrameTaker& frames, std::size_t before)
{
    RunProgress so_far;
    so_far.all = walls.size();
    so_far.before = before;
    RowBuffer rows(store);
    PushList list;
    list.size = walls.size();
    list.wall = [&](std::size_t i) -> WantedWall {
        const int level = static_cast<int>(walls[i].level);
        return {level, draw(plan, level, static_cast<int>(walls[i].sample))};
    };
    list.done = [&](std::size_t i, const WallDraw& drawn, PushedWall&& wall) {
        const bool failed = dem::failed(wall.result.outcome);
        so_far.failed += failed ? 1 : 0;
        ++so_far.done;
        rows.add(row_of(walls[i], drawn, wall));
        if (frames && !failed)
            frames(walls[i], wall.reading.mode, frames_of(std::move(wall.result)));
        if (seen) seen(so_far);
    };
    try {
        push_in_layouts(
            study, frames ? filmed_plan(study) : bare_plan(study), list,
            [&](std::size_t i) { return walls[i].sample; }, threads);
    } catch (...) {
        rows.flush();
        throw;
    }
    rows.flush();
    return so_far;
}

} // namespace app
