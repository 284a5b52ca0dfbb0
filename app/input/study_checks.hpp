#pragma once
/// Rules that tie the values of a study to each other.

#include "app/input/study.hpp"

namespace app {

/// Joint stiffness: where it comes from, and one value per stress level. Before defaults are
/// derived from it.
/// @throws ConfigError at the value to change
void check_stiffness(const Study& study);

/// Everything else, once every value is known.
/// @throws ConfigError at the value to change
void check_relations(const Study& study);

/// Samples behind p-values, also where no study was read.
/// @throws ConfigError where they are too few for a law to be rejected
void check_bootstrap(const Study& study);

} // namespace app
