#pragma once
/// `drystone scene`: the wall that a study describes, before anything is computed.

#include "app/input/command.hpp"

namespace app {

/// Writes scene.svg, scene.json and scene.dxf, and says what the wall is. The last two hold whole units in the
/// unit of wall.length_unit, and are read again with wall.geometry.
/// @return exit code
/// @throws ConfigError, StoreError, std::runtime_error
[[nodiscard]] int scene_command(const Command& command);

} // namespace app
