#pragma once
/// The push the other way: walls that are not symmetric carry less in it, or more.

#include "app/sampling/wall_draw.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "dem/block/model.hpp"

#include <functional>
#include <future>
#include <vector>

namespace app {

/// Walls that are not symmetric, pushed the other way beside their own push, on half of the
/// threads, where load.direction = both is given; without that key, where it costs little.
/// Other walls are left alone. Piers are read as in a push of its own; of snapshots it keeps
/// peak and end.
class OtherWay {
  public:
    /// @param study, model, wanted must outlive this
    /// @param look is called every few hundred steps from any thread; what it throws ends this
    /// push. May be empty
    /// @throws ConfigError where both directions are asked for and cracks are placed for one
    OtherWay(const Study& study, const dem::Model& model, const std::vector<WantedWall>& wanted,
             int threads, std::function<void()> look = {});

    /// For the push itself, >= 1.
    [[nodiscard]] int threads_left() const { return threads_left_; }

    /// Waits, and gives each wall its push the other way.
    /// @throws what `look` or push_walls throw
    void add_to(std::vector<PushedWall>& walls);

  private:
    int threads_left_;
    std::future<std::vector<PushedWall>> walls_; ///< not valid where nothing is pushed
};

} // namespace app
