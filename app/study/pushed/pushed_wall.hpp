#pragma once
/// One wall pushed: what was run, and how it is read.

#include "app/reading/wall_numbers.hpp"
#include "app/sampling/wall_draw.hpp"
#include "app/study/pushed/pier_reading.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "dem/solver/push.hpp"

#include <string>
#include <vector>

namespace app {

struct LoadInput;
struct OutputInput;

struct PushedWall {
    double vertical_stress = 0.0; ///< [Pa]
    dem::Loads loads;
    dem::PushResult result;
    /// The curve as the file of a study keeps it [m] [N]: of single precision where
    /// output.curves says so.
    std::vector<double> displacement, force;
    dem::Mechanism mechanism;
    WallReading reading; ///< by the rules of the study; without a mode where the run failed
    std::vector<PierReading> piers; ///< empty: not told apart (pier_reading.hpp)
    std::vector<SpandrelReading> spandrels;
    PierBalance pier_balance; ///< of these piers
    /// The same wall pushed the other way (other_way.hpp); one or none.
    std::vector<PushedWall> other_way;
};

/// Evaluates a finished push: peak, stiffness, limit states, mechanism, failure mode.
/// @param level index in LoadInput::vertical_stress
[[nodiscard]] PushedWall read_wall(const ReadingRules& rules, const LoadInput& load,
                                   const OutputInput& output, int level,
                                   dem::PushResult result);

/// A draw that makes no wall: nothing was pushed, and the wall counts as failed.
[[nodiscard]] PushedWall no_wall(const ReadingRules& rules, const LoadInput& load, int level,
                                 const std::string& why);

/// Source of its numbers (kWallNumbers), no longer than the wall lives.
[[nodiscard]] WallSource source_of(const PushedWall& wall);

/// The same with another reading of it, such as that of one backbone.
[[nodiscard]] WallSource source_of(const PushedWall& wall, const WallReading& reading);

/// Estimated error of the peak force by the speed of the drive [-], >= 0; NaN where the run
/// gave no result, or the wall came down before it was pushed.
[[nodiscard]] double solver_error(const PushedWall& wall);

/// Whether a wall was lost under its vertical load, or before its curve had a second point: it
/// has no mode.
[[nodiscard]] bool came_down_at_once(const PushedWall& wall);

} // namespace app
