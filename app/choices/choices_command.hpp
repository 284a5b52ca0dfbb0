#pragma once
#include "app/input/command.hpp"

namespace app {

/// `drystone choices`: the wall of a study's mean values, changed in one choice at a time: a
/// table (choices.csv, .md, .tex) and a picture (choices.svg) of what matters for this wall.
/// Choices that do not apply are named with the reason.
/// @throws Interrupted (app/study/pushed/interrupt.hpp): nothing was written
[[nodiscard]] int choices_command(const Command& command);

} // namespace app
