#pragma once
/// Rules that tie the values of a study to each other.

#include "dem/scene/layout.hpp"

#include <string>

namespace app {

struct FragilityInput;
struct LoadInput;
struct Masonry;
struct Study;
struct StudyFile;

/// Checks that a push to and fro is not endless, before its path is made.
/// @throws ConfigError at the value to change
void check_cycles(const LoadInput& load, const StudyFile& source);

/// Why load.height does not fit the wall; empty if it does.
/// @param top of the masonry [m]
[[nodiscard]] std::string unfit_height(const LoadInput& load, const dem::Beam& beam,
                                       double top);

/// Refuses blocks and pieces of joint of a wall in courses that are too short.
/// @throws ConfigError at the value to change
void check_blocks(const Masonry& masonry, const StudyFile& source, const dem::Layout& layout);

/// Checks all other rules, once every value is known.
/// @throws ConfigError at the value to change
void check_relations(const Study& study);

/// Checks the number of samples behind p-values, also where no study was read.
/// @throws ConfigError where they are too few for a law to be rejected
void check_bootstrap(const FragilityInput& fragility, const StudyFile& source);

} // namespace app
