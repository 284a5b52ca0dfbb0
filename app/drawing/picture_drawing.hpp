#pragma once
/// A picture of stones becomes blocks that fill its rectangle.

#include "app/drawing/drawing.hpp"
#include "app/drawing/raw_drawing.hpp"

#include <string_view>

namespace app {

/// @throws ConfigError
[[nodiscard]] Drawing read_picture(const DrawingFrame& frame, std::string_view bytes,
                                   const DrawingOptions& options);

} // namespace app
