#pragma once
/// One wall pushed, for tests of what is read off pushes.

#include "app/input/prepared_study.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "dem/block/model.hpp"

#include <cstddef>
#include <utility>

namespace scenes {

/// The wall of the study's mean values, pushed by this plan.
inline app::PushedWall pushed(const app::Study& study, const dem::PushPlan& plan)
{
    const dem::Model model = app::model_of(app::prepare(study));
    app::PushedWall wall;
    app::PushList list;
    list.size = 1;
    list.wall = [](std::size_t) { return app::WantedWall{}; };
    list.done = [&](std::size_t, const app::WallDraw&, app::PushedWall&& w) {
        wall = std::move(w);
    };
    app::push_walls(study, model, plan, list, 1);
    return wall;
}

inline app::PushedWall pushed(const app::Study& study)
{
    return pushed(study, app::push_plan(study));
}

} // namespace scenes
