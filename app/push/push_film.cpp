#include "app/push/push_film.hpp"

#include "app/output/picture/film_svg.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

PushFilm::PushFilm(const LoadInput& load, std::size_t walls, dem::PushPlan& plan)
    : walls_(walls)
{
    const bool series = plan.snapshot_every > 0.0;
    const double step = film_step(load);
    if (series)
        every_ =
            static_cast<std::size_t>(std::max(1.0, std::round(step / plan.snapshot_every)));
    else
        plan.snapshot_every = step;
    plan.sink = {
        .take =
            [this, series, next = plan.sink.take](std::size_t wall, dem::Snapshot&& shot) {
                Taken& taken = walls_.at(wall);
                if (taken.seen++ % every_ == 0) taken.frames.push_back(shot);
                if (series) next(wall, std::move(shot));
            },
        .forget =
            [this, next = plan.sink.forget](std::size_t wall) {
                walls_.at(wall) = {};
                next(wall);
            }};
}

std::vector<dem::Snapshot> PushFilm::frames_of(std::size_t wall, const PushedWall& w) const
{
    std::vector<dem::Snapshot> frames = walls_.at(wall).frames;
    if (frames.empty() || frames.back().displacement != w.result.at_end.displacement)
        frames.push_back(w.result.at_end);
    if (frames.size() < 2)
        frames.insert(frames.begin(), frames.front()); // it came down at once
    return frames;
}

namespace {

FilmText film_text(const dem::Layout& layout, const PushedWall& w)
{
    return {"Wall under " + stress_text(w.vertical_stress), w.loads.height,
            stone_tints(layout)};
}

} // namespace

std::string PushFilm::film(const dem::Layout& layout, std::size_t wall,
                           const PushedWall& w) const
{
    return film_svg(frames_of(wall, w), w.displacement, w.force, film_text(layout, w));
}

std::vector<std::string> PushFilm::stills(const dem::Layout& layout, std::size_t wall,
                                          const PushedWall& w) const
{
    return film_stills(frames_of(wall, w), w.displacement, w.force, film_text(layout, w));
}

} // namespace app
