#pragma once
/// A wall that was pushed one way or both: what is read off both, and the words for it.

#include "app/study/pushed/pushed_wall.hpp"

#include <cstddef>
#include <string>

namespace app {

struct GeometryInput;
struct LoadInput;
struct StudyFile;

/// Whether the push goes one way and the wall is not symmetric.
[[nodiscard]] bool has_other_way(const LoadInput& load, const dem::Layout& layout);

/// Whether the walls of a study are pushed both ways: where the study asks for it, and walls
/// are not symmetric.
/// @throws ConfigError where cracks are placed for one direction
[[nodiscard]] bool pushes_both_ways(const GeometryInput& geometry, const LoadInput& load,
                                    const StudyFile& source, const dem::Layout& layout);

/// @throws ConfigError where cracks are placed for one direction
void refuse_cracks_of_one_way(const StudyFile& source);

/// "right" of 1, "left" of -1
[[nodiscard]] const char* way_name(int direction);

/// nullptr where the wall was pushed one way alone.
[[nodiscard]] const PushedWall* other_way_of(const PushedWall& wall);

/// The smaller of each number of both directions; the reading of the wall itself where it was
/// pushed one way, or one of them cannot be read.
[[nodiscard]] WallReading worse_way(const PushedWall& wall);

/// The same of the readings of both directions.
[[nodiscard]] WallReading worse_way(const WallReading& own, const WallReading& other);

/// The push whose limit is the one of worse_way(): this one where both reach it together.
/// @param state index in WallReading::limits
[[nodiscard]] const PushedWall& worse_push(const PushedWall& wall, std::size_t state);

/// The direction whose limit is the one of worse_way(): "left", "right", or "both" where they
/// are the same.
/// @param direction of the push of this wall: 1 or -1
/// @param state index in WallReading::limits
[[nodiscard]] std::string worse_way_name(int direction, const PushedWall& wall,
                                         std::size_t state);

/// The value of load.direction that turns the push round.
[[nodiscard]] std::string turned_word(const LoadInput& load);

/// Whether cracks were placed for one direction.
[[nodiscard]] bool has_cracks_of_one_way(const StudyFile& source);

/// Says what a wall that is not symmetric carries each way, or how to find out, without a full
/// stop. Empty for any other wall.
[[nodiscard]] std::string other_way_remark(const LoadInput& load, const StudyFile& source,
                                           const dem::Layout& layout, const PushedWall& wall);

} // namespace app
