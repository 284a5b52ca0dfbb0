#pragma once
/// Changes of a study's own wall, one at a time, that ask which choice matters here.

#include "app/input/prepared_study.hpp"

#include <span>
#include <string>
#include <vector>

namespace app {

/// A change of one choice, and the study it makes.
struct ChoiceChange {
    std::string key;                      ///< "wall.base"
    std::string before;                   ///< "joint"
    std::string after;                    ///< "fixed"
    std::vector<std::string> assignments; ///< "wall.base=fixed", and what has to go with it
    std::string not_applied; ///< why this wall has no such choice; empty: `ready` is it
    PreparedStudy ready;
};

/// All changes, in the order of a table. What does not apply says why.
/// @param overrides of the command line, which stay but where a change replaces them
/// @throws ConfigError where the study itself cannot be read
[[nodiscard]] std::vector<ChoiceChange> choice_changes(const std::string& path,
                                                       std::span<const std::string> overrides);

} // namespace app
