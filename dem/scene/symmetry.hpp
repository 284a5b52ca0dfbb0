#pragma once
/// Whether a wall is its own mirror image.

#include "dem/scene/layout.hpp"

namespace dem {

/// Whether every block, with its stone, and every potential crack has its like on the other
/// side of the wall's middle. The beam, supports and materials of joints are not looked at.
[[nodiscard]] bool is_symmetric(const Layout& layout);

} // namespace dem
