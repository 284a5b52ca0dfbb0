#pragma once
/// Walls side by side in the lanes of one Real, each with its own clock. When a wall is done,
/// the next one takes its lane at once. ensemble.hpp has the picture.

#include "dem/solver/wall_run.hpp"

#include <functional>
#include <optional>

namespace dem {

struct NumberedWall {
    std::size_t number = 0;
    WallMaterials materials;
};

/// Pushes the walls that `next` hands out, until all are done and it has no more. Free lanes
/// ask again while others run.
/// @param most_lanes number of lanes to use, >= 1; fewer than there are leaves walls for other
/// threads
/// @param done takes each result as soon as it is there
template <class Real>
void run_batch(const Task& task, int most_lanes,
               const std::function<std::optional<NumberedWall>()>& next,
               const std::function<void(std::size_t number, PushResult&&)>& done);

} // namespace dem
