#pragma once
/// Which walls a push is asked for.

#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "app/study/stored/numbered_walls.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace app {

struct StudySource {
    PreparedStudy ready;
    std::vector<std::uint32_t> sizes; ///< through which the design has grown
    std::string
        other_revision; ///< sentence, where another revision of the solver pushed the walls of the file
};

/// From a study file, or from the file of its results: the walls of a study that has grown can
/// only be drawn again with the sizes that the latter keeps.
/// @throws ConfigError, StoreError
[[nodiscard]] StudySource study_source(const std::string& path,
                                       std::span<const std::string> overrides,
                                       Purpose purpose = Purpose::push);

/// With uq.drawn, the wall that it names. With a sample and a level, that wall of a study
/// with distributions. Otherwise the wall of the study's numbers under all its levels or that
/// of the choice; with `mean`, each distribution stands for its mean.
/// @throws ConfigError
[[nodiscard]] std::vector<WantedWall> wanted_walls(const StudySource& source,
                                                   const WallChoice& choice);

} // namespace app
