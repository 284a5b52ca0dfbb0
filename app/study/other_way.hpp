#pragma once
/// Walls that are not symmetric carry less when they are pushed the other way, or more. What
/// outputs say of it stands here.

#include "app/sampling/wall_draw.hpp"
#include "app/study/other_way_remark.hpp"
#include "app/study/pushed_wall.hpp"
#include "app/study/study_walls.hpp"
#include "dem/block/model.hpp"

#include <functional>
#include <future>
#include <string>
#include <vector>

namespace app {

/// Walls that are not symmetric, pushed the other way beside their own push where that costs
/// little: as much as the push itself, on half of the threads. Other walls, and dear ones, are
/// left alone.
class OtherWay {
  public:
    /// @param study, model, wanted must outlive this
    /// @param look is called every few hundred steps from any thread; what it throws ends this
    /// push. May be empty
    OtherWay(const Study& study, const dem::Model& model, const std::vector<WantedWall>& wanted,
             int threads, std::function<void()> look = {});

    /// For the push itself, >= 1.
    [[nodiscard]] int threads_left() const { return threads_left_; }

    /// Waits, and gives each wall its reading of the other way.
    /// @throws what `look` or push_walls throw
    void add_to(std::vector<PushedWall>& walls);

  private:
    int threads_left_;
    std::future<std::vector<WallReading>> readings_; ///< not valid where nothing is pushed
};

/// The sentence for a study, whose walls are pushed one way. Empty where there is no other way.
[[nodiscard]] std::string other_way_remark(const StudyWalls& walls);

} // namespace app
