#pragma once
/// Outlines of a drawing, each drawn for itself, become blocks that fit together.

#include "app/drawing/drawing.hpp"
#include "app/drawing/raw_drawing.hpp"

namespace app {

/// @param snap [m]
/// @throws ConfigError
[[nodiscard]] Drawing fit_drawing(RawDrawing raw, double snap);

} // namespace app
