#pragma once
/// Codes limit the drift of a pier. A wall of several piers has one drift and one mode here,
/// which is said.

#include "dem/scene/wall.hpp"

#include <string>
#include <string_view>

namespace app {

struct Masonry;
struct ReadingRules;

/// Caption of tables of piers.
inline constexpr std::string_view kPierNumbers =
    "N: compression, V: shear, in a cut through all piers of a storey, when the wall carries "
    "most. Drift: of the upper end of a pier against its lower end, over its own height, at "
    "the "
    "end of the push. H0/D: moment over shear and length, when the pier carries most.";

/// Caption of tables of spandrels.
inline constexpr std::string_view kSpandrelNumbers =
    "Masonry and lintel above each opening, cut in the middle of the opening, when the wall "
    "carries most: N, compression along the wall; V, by how much its right half presses its "
    "left half down. Drift: by how much its right end is lower than its left end, over its "
    "length, at the end of the push.";

/// Whether openings divide the masonry into pieces that stand upright beside each other: walls
/// with doors or windows, portals, arches on piers. A bare arch leans all the way from its
/// springing, and has none.
[[nodiscard]] bool has_piers(const Masonry& masonry);

/// "the drift limits of ntc are those of one pier: ..."; empty without a code among the limit
/// states, and of a wall that is one pier. No full stop.
[[nodiscard]] std::string pier_remark(const ReadingRules& rules, const Masonry& masonry);

/// The same as a sentence.
[[nodiscard]] std::string pier_sentence(const ReadingRules& rules, const Masonry& masonry);

} // namespace app
