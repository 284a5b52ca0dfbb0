#pragma once
/// Where units may crack, as a study says it.

#include "dem/scene/crack_pattern.hpp"
#include "dem/scene/geometry/polygon.hpp"

#include <vector>

namespace app {

struct Masonry;
struct Study;
struct StudyFile;

/// Reads `unit.cracks` and what belongs to it into Study::wall. The region `toe` is the lower
/// 40 % of the half of the wall that it is pushed towards; of both halves where it is pushed to
/// and fro.
/// @throws ConfigError
void read_unit_cracks(Study& study);

/// Refuses patterns that make so many pieces that laying them would take minutes and gigabytes.
/// Before they are laid.
/// @throws ConfigError
void check_pieces_of_units(const Masonry& masonry, const StudyFile& source);

/// Whether `unit.cracks_where = needed` has still to be carried out.
[[nodiscard]] bool asks_for_needed_cracks(const Masonry& masonry, const StudyFile& source);

/// Puts boxes in the place of `unit.cracks_where = needed` (app/input/needed_cracks.hpp), in
/// which form the study is kept.
void put_cracks(const std::vector<dem::Region>& boxes, Study& study);

/// Patterns of the units in the region of unit.cracks_where, and of the others, as the texts of
/// the study say: they are there before the keys that depend on them are read.
struct CrackPatterns {
    dem::CrackPattern pattern, elsewhere;
};

/// Patterns that units may crack in; none for a drawn wall that no pattern cuts.
/// @throws ConfigError
[[nodiscard]] CrackPatterns crack_patterns(const Masonry& masonry, const StudyFile& source);

/// Whether units may crack in a pattern that a condition holds for.
/// @throws ConfigError
template <class Holds>
[[nodiscard]] bool any_pattern(const Masonry& masonry, const StudyFile& source, Holds holds)
{
    const CrackPatterns p = crack_patterns(masonry, source);
    return holds(p.pattern) || (!masonry.cracks.where.empty() && holds(p.elsewhere));
}

/// Whether any unit may crack.
[[nodiscard]] bool has_cracks(const Masonry& masonry, const StudyFile& source);

} // namespace app
