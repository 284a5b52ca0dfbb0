#pragma once
/// Pictures of the stones that were found.

#include "app/photograph/photograph.hpp"

namespace app {

/// Each stone in a colour of its own, mortar black, openings magenta: wall.geometry reads it.
[[nodiscard]] Picture painted_picture(const Labels& labels);

/// The photograph with the borders of what was found drawn over it.
[[nodiscard]] Picture found_picture(const FoundStones& found);

} // namespace app
