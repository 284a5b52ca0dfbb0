#include "app/report/report_replay.hpp"

#include "app/input/study/units.hpp"
#include "app/study/push_layouts.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "dem/scene/layout.hpp"

#include <stdexcept>
#include <utility>

namespace app {
namespace {

WallDraw stored_draw(const Sampling& sampling, const dem::Layout& layout, const StudyWall& wall)
try {
    return draw_of(sites_of(sampling.random, sampling.uq.spatial, layout), wall.drawn);
} catch (const BadValue&) {
    throw std::runtime_error("the stored values do not fit the stored configuration");
}

/// The same curve to the bit, and the same mode.
bool same_as_stored(const StudyWall& stored, const PushedWall& wall)
{
    return first_way(stored).mode == wall.reading.mode &&
           stored.curve.displacement == wall.displacement && stored.curve.force == wall.force;
}

/// Pushes the walls at places `missing` of `all` and puts their films there.
void push_missing(const PreparedStudy& ready, const std::vector<std::size_t>& missing,
                  int threads, Replay& all,
                  const std::function<void(std::size_t, std::size_t)>& seen)
{
    PushList list;
    list.size = missing.size();
    list.wall = [&](std::size_t i) -> WantedWall {
        const StudyWall& wall = *all.walls[missing[i]];
        return {static_cast<int>(wall.key.level), stored_draw(ready.study, ready.layout, wall)};
    };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        const StudyWall& stored = *all.walls[missing[i]];
        all.different += same_as_stored(stored, wall) ? 0 : 1;
        all.films[missing[i]] = film_of(frames_of(std::move(wall.result)));
        ++all.pushed;
        if (seen) seen(all.pushed, missing.size());
    };
    dem::PushPlan plan = filmed(push_plan(ready.study), ready.study.load);
    plan.progress = [](const dem::PushProgress&) { end_if_interrupted(); };
    push_in_layouts(
        ready, plan, list, [&](std::size_t i) { return all.walls[missing[i]]->key.sample; },
        threads);
}

} // namespace

Replay replay(const PreparedStudy& ready, const WallList& walls, int threads,
              const FilmShelf& shelf, const std::function<void(std::size_t, std::size_t)>& seen)
{
    Replay all;
    all.walls = walls;
    all.films.resize(walls.size());
    std::vector<std::size_t> missing; // places in `walls`
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const Film* const film = shelf.find(walls[i]->key);
        if (film != nullptr)
            all.films[i] = *film;
        else
            missing.push_back(i);
    }
    if (!missing.empty()) push_missing(ready, missing, threads, all, seen);
    return all;
}

void keep_first(Replay& replay, std::size_t bytes, std::size_t each)
{
    std::size_t kept = 0;
    for (const Film& film : replay.films) {
        const std::size_t size = film.data.size() + kFilmEntryBytes + each;
        if (size > bytes) break;
        bytes -= size;
        ++kept;
    }
    replay.walls.resize(kept);
    replay.films.resize(kept);
}

} // namespace app
