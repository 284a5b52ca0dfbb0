#pragma once
/// The study in sentences: what was run, what came out, how sure.

#include "app/study/study_walls.hpp"

#include <string>
#include <vector>

namespace app {

struct Overview {
    std::vector<std::string> run, found, sure; ///< plain text
};
[[nodiscard]] Overview overview(const StudyWalls& study);

} // namespace app
