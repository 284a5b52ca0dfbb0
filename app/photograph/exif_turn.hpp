#pragma once
/// How a camera was held.

#include "app/drawing/trace/picture.hpp"

#include <string_view>

namespace app {

/// The orientation that the EXIF of a JPEG file states, 1 to 8 (JEITA CP-3451, tag 0x0112); 1,
/// upright, where it states none.
[[nodiscard]] int exif_orientation(std::string_view jpeg);

/// The picture as it is seen when the orientation is heeded.
[[nodiscard]] Picture turned(Picture picture, int orientation);

} // namespace app
