#pragma once
#include "app/input/command.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/study/pushed/pushed_wall.hpp"

namespace app {

/// `drystone sheet`: one A4 page of a wall of mean values, and of the random walls of a stored
/// study: drawing, curve, mechanism, limits, assumptions, certainty. Writes FILE.html and,
/// where WeasyPrint is installed, FILE.pdf.
/// @throws Interrupted (app/study/pushed/interrupt.hpp): nothing was written
[[nodiscard]] int sheet_command(const Command& command);

/// The curve of a wall with its limits, as wide as a sheet shows it.
[[nodiscard]] Chart sheet_curve(const ReadingRules& rules, const PushedWall& wall);

} // namespace app
