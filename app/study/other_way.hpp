#pragma once
/// Walls that are not symmetric carry less when they are pushed the other way, or more. What
/// outputs say of it stands here.

#include "app/sampling/wall_draw.hpp"
#include "app/study/both_ways.hpp"
#include "app/study/pushed_wall.hpp"
#include "app/study/study_walls.hpp"
#include "dem/block/model.hpp"

#include <functional>
#include <future>
#include <string>
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

/// A wall of a study that was pushed both ways: the worse one stands for it. It has failed
/// where one of both has.
[[nodiscard]] StudyWall with_other_way(StudyWall wall, StudyWall other,
                                       const ReadingRules& rules);

/// The sentence for a study: how to find out about the other direction, or how often each of
/// both governs. Empty where there is no other way.
[[nodiscard]] std::string other_way_remark(const StudyWalls& walls);

} // namespace app
