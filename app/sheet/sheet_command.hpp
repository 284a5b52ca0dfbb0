#pragma once
#include "app/input/command.hpp"

namespace app {

/// `drystone sheet`: one A4 page of a wall of mean values, and of the random walls of a stored
/// study: drawing, curve, mechanism, limits, assumptions, certainty. Writes FILE.html and,
/// where WeasyPrint is installed, FILE.pdf.
/// @throws Interrupted (app/study/interrupt.hpp): nothing was written
[[nodiscard]] int sheet_command(const Command& command);

} // namespace app
