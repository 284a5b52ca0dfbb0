#pragma once
/// The walls of `drystone push`, with one line that shows how far they are, until they are done
/// or the program is told to end.

#include "app/input/prepared_study.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "dem/solver/push.hpp"

#include <vector>

namespace app {

struct Pushed {
    std::vector<PushedWall> walls; ///< as they were wanted
    bool whole =
        false; ///< else the program was told to end: curves end early, or have no point
    bool other_way_left_out =
        false; ///< the program was told to end when nothing else was left to push
};

/// Walls that are not symmetric are pushed the other way at the same time.
/// @param plan where to push the walls
/// @throws Interrupted (app/study/pushed/interrupt.hpp) where the program is told to end before
/// any wall has a curve
[[nodiscard]] Pushed push_until_told(const PreparedStudy& ready, dem::PushPlan plan,
                                     const std::vector<WantedWall>& wanted, int threads,
                                     bool quiet);

} // namespace app
