#pragma once
/// The motions that section [shaking] of a study asks for.

#include "app/input/study.hpp"
#include "ground/ground_motion.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// One history: a record of one intensity.
struct ShakingMotion {
    std::string name;                             ///< of the record, with its intensity
    ground::GroundMotion horizontal;              ///< scaled
    std::optional<ground::GroundMotion> vertical; ///< scaled by the same factor, as long
};

/// Each record under each intensity. Files of records are seen from the folder of the study.
/// @throws ConfigError
[[nodiscard]] std::vector<ShakingMotion> shaking_motions(const Study& study);

} // namespace app
