#pragma once
/// Which walls a push is asked for.

#include "app/input/command.hpp"
#include "app/input/study.hpp"
#include "app/sampling/wall_draw.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

struct StudySource {
    Study study;
    std::vector<std::uint32_t> sizes; ///< through which the design has grown
    std::string
        other_revision; ///< sentence, where another revision of the solver pushed the walls of the file
};

/// From a study file, or from the file of its results: the walls of a study that has grown can
/// only be drawn again with the sizes that the latter keeps.
/// @throws ConfigError, StoreError
[[nodiscard]] StudySource study_source(const Command& command, Purpose purpose = Purpose::push);

/// Index of the level given as text, such as "0.75 MPa"; the only one if the text is empty.
/// @throws ConfigError about --level
[[nodiscard]] int level_of(const Study& study, const std::string& text);

/// With uq.drawn, the wall that it names. With --sample N and --level, that wall of a study
/// with distributions. Otherwise the wall of the study's numbers under all its levels or that
/// of --level; with --sample mean, each distribution stands for its mean.
/// @throws ConfigError
[[nodiscard]] std::vector<WantedWall> wanted_walls(const StudySource& source,
                                                   const Command& command);

} // namespace app
