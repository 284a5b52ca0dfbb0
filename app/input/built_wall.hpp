#pragma once
/// The wall that the keys of a study describe, where no outlines are drawn: courses with openings, or rubble.

#include "app/input/study.hpp"

namespace app {

/// Reads the heights of courses, the stones of rubble, the patterns of cracks and the openings.
/// @throws ConfigError
void read_built_wall(Study& study);

} // namespace app
