#pragma once
/// Walls side by side in the lanes of one Real, each with its own clock. A wall that is done
/// leaves its lane to the next at once.

#include "dem/solver/wall_run.hpp"

#include <functional>
#include <optional>

namespace dem {

struct NumberedWall {
    std::size_t number = 0;
    WallMaterials materials;
};

/// Pushes what `next` hands out, until it has no more.
/// @param most_lanes used at a time, >= 1: leaves walls for other threads where there are few
/// @param done gets each result as soon as there is one
template <class Real>
void run_batch(const Task& task, int most_lanes,
               const std::function<std::optional<NumberedWall>()>& next,
               const std::function<void(std::size_t number, PushResult&&)>& done);

} // namespace dem
