#pragma once
/// Pictures of the stones that were found.

#include "app/photograph/photograph.hpp"

namespace app {

/// Each stone in a colour of its own, mortar black, openings in theirs: what wall.geometry reads.
[[nodiscard]] Picture painted_picture(const Labels& labels);

/// The photograph with the borders of what was found drawn over it.
[[nodiscard]] Picture found_picture(const FoundStones& found);

} // namespace app
