#pragma once
/// Tables of the piers and spandrels of pushed walls.

#include "app/output/table/table.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <string>
#include <vector>

namespace app {

/// One row for each pier, of a wall pushed both ways for each direction. No rows where piers
/// are not told apart.
[[nodiscard]] Table pier_table(const ReadingRules& rules, const std::vector<PushedWall>& walls);

/// Limit states of each pier as of a wall of its own: of its shear over its own movement.
[[nodiscard]] Table pier_limit_table(const ReadingRules& rules,
                                     const std::vector<PushedWall>& walls);

/// One row for each spandrel.
[[nodiscard]] Table spandrel_table(const ReadingRules& rules,
                                   const std::vector<PushedWall>& walls);

/// "pushed to the right, pier 3 is the first to reach the drift limit of ntc, 1 %, when the
/// load has moved by 14.2 mm" for each direction, without a full stop. None where piers are not
/// told apart, or no code is among the limit states.
[[nodiscard]] std::vector<std::string> piers_remarks(const ReadingRules& rules,
                                                     const PushedWall& wall);

/// A paragraph for each direction: "Piers, pushed to the right: 1 (0.30 x 2.10 m) N 61 kN, V 3
/// kN, drift 0.40 %, rocking; ...". None where piers are not told apart.
[[nodiscard]] std::vector<std::string> pier_paragraphs(const ReadingRules& rules,
                                                       const PushedWall& wall);

/// "; pier 3 is the first to reach it" of a limit state that the drift limit of a code governs;
/// else empty.
/// @param index of this state in WallReading::limits
[[nodiscard]] std::string pier_note(const ReadingRules& rules, const PushedWall& wall,
                                    const StateName& state, std::size_t index);

/// "pier 3 reaches the drift that ntc allows it, 0.5 %" of such a limit state; else empty.
[[nodiscard]] std::string pier_rule(const ReadingRules& rules, const PushedWall& wall,
                                    const StateName& state, std::size_t index);

} // namespace app
