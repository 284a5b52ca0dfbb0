#pragma once
/// A study that is ready to run: its wall is laid out, and what only a push can tell is found.

#include "app/input/study/study.hpp"
#include "dem/block/model.hpp"
#include "dem/scene/layout.hpp"

#include <cstdint>

namespace app {

struct PreparedStudy {
    Study study;        ///< needed cracks are boxes, a scaled protocol is as it was found
    dem::Layout layout; ///< of the wall with its beam
};

/// Grows the stones of rubble, lays the wall out and checks it; then carries out
/// unit.cracks_where = needed and load.protocol_scale = one_way, which push the wall. The one
/// place that does any of this for a study.
/// @throws ConfigError at the value to change
[[nodiscard]] PreparedStudy prepare(Study study);

/// The same study with another wall: laid out and checked, and nothing else.
/// @throws ConfigError
[[nodiscard]] PreparedStudy lay_again(Study study);

/// The study with this layout alone, as wall.seed would give it. Only its wall is laid again.
/// @throws ConfigError if the layout makes no wall
[[nodiscard]] PreparedStudy in_layout(Study study, std::uint32_t seed);

/// One for all levels: modes and masses of the first level's stiffness, which sets the step,
/// not the answer. Each wall brings its own stress.
/// @throws ConfigError
[[nodiscard]] dem::Model model_of(const PreparedStudy& ready);

} // namespace app
