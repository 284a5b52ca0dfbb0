#pragma once
/// Codes limit the drift of a pier. A wall of several piers has one drift and one mode here,
/// which is said.

#include <string>
#include <string_view>

namespace app {

struct Study;

/// Caption of tables of piers.
inline constexpr std::string_view kPierNumbers =
    "N: compression, V: shear, in a cut through all piers of a storey, when the wall carries "
    "most. Drift: of the upper end of a pier against its lower end, over its own height, at "
    "the "
    "end of the push. H0/D: moment over shear and length, when the pier carries most.";

/// Whether openings divide the masonry into pieces that stand upright beside each other: walls
/// with doors or windows, portals, arches on piers. A bare arch leans all the way from its
/// springing, and has none.
[[nodiscard]] bool has_piers(const Study& study);

/// "the drift limits of ntc are those of one pier: ..."; empty without a code among the limit
/// states, and of a wall that is one pier. No full stop.
[[nodiscard]] std::string pier_remark(const Study& study);

/// The same as a sentence.
[[nodiscard]] std::string pier_sentence(const Study& study);

} // namespace app
