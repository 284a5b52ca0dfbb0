#pragma once
/// The wall that the keys of a study describe, where no outlines are drawn: courses with
/// openings, or rubble.

#include "dem/scene/wall.hpp"

namespace app {

struct Masonry;
struct Study;
struct StudyFile;

/// Number of units of a wall in courses, without openings, or of mean stones of rubble.
[[nodiscard]] double unit_count(const Masonry& masonry, const StudyFile& source);

/// Reads the heights of courses, the patterns of cracks and the openings.
/// @throws ConfigError
void read_built_wall(Study& study);

/// Fills a wall of rubble with the stones of its seed.
void grow_rubble(Masonry& masonry);

} // namespace app
