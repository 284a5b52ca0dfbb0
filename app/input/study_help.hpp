#pragma once
/// The keys of a study for people: what each means, its range and its default.

#include <string>

namespace app {

/// From the table of study_keys, section by section.
[[nodiscard]] std::string study_help();

} // namespace app
