#pragma once
/// Legend of the marks on a wall: what they mean, and how large they are.

#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_body.hpp"
#include "app/output/picture/wall_marks.hpp"

#include <string>

namespace app {

[[nodiscard]] double wall_legend_height(const MarkSizes& sizes,
                                        const StoneTints& tints); ///< [px]

/// Two rows of three entries, each a sample and what it stands for; a third row where something
/// has crushed, or units have other stone than the wall.
/// @param mark_size WallView::mark_size
/// @param widest_force compression of one face drawn with kThrustWidest [N]; 0: none in the
/// picture
[[nodiscard]] std::string draw_wall_legend(Pixel top_left, double width, const MarkSizes& sizes,
                                           double widest_force, double mark_size,
                                           const StoneTints& tints = {});

} // namespace app
