#pragma once
/// A deformed wall and the thrust through it. Each function gives SVG elements.

#include "app/output/svg_elements.hpp"
#include "app/output/wall_view.hpp"
#include "dem/scene/snapshot.hpp"

#include <string>

namespace app {

inline constexpr const char* kThrustColour = "#8aa399";
inline constexpr double kThrustWidest = 11.0; // [px] at mark_size 1

/// Faint undeformed blocks.
[[nodiscard]] std::string draw_undeformed(const dem::Snapshot& wall, const WallView& view);

/// Deformed blocks; the halves of a unit look like one stone.
[[nodiscard]] std::string draw_blocks(const dem::Snapshot& wall, const WallView& view);

/// Lines from the centre of each block to the compression resultants of its faces, as wide as
/// their force.
/// @param widest_force drawn with kThrustWidest [N]; nothing is drawn if it is 0
[[nodiscard]] std::string draw_thrust(const dem::Snapshot& wall, const WallView& view,
                                      double widest_force);

} // namespace app
