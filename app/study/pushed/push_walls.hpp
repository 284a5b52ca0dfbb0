#pragma once
/// The one place that pushes walls of a study.

#include "app/sampling/wall_draw.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "dem/solver/push.hpp"

#include <cstddef>
#include <functional>
#include <optional>

namespace app {

/// Walls to push, and who takes what came of them.
struct PushList {
    std::size_t size = 0;
    /// Wall `i`, asked for from any thread when its turn comes, so that a study of any size
    /// needs no more memory than what is running. Nothing: there is none for now.
    std::function<std::optional<WantedWall>(std::size_t i)> wall;
    /// Takes each wall when it is there, one at a time, in no order. A draw that makes no wall
    /// is a failed wall with its reason.
    std::function<void(std::size_t i, const WallDraw& draw, PushedWall&& wall)> done;
    /// Walls may come while others run: dem::Ensemble::open.
    bool open = false;
    /// Told to end, the program begins no further wall and takes those that are begun: the plan
    /// has to end them.
    bool keeps_begun = false;
};

/// A wall has the same bits whatever the number of threads and the walls beside it.
/// @param plan where to push the walls, and what to keep of each push
/// @throws Interrupted unless the list keeps what is begun; what `wall` or `done` throw. Walls
/// on their way are then left.
void push_walls(const Study& study, const dem::Model& model, const dem::PushPlan& plan,
                const PushList& list, int threads);

} // namespace app
