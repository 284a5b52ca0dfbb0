#pragma once
/// A deformed wall and the thrust through it. Each function gives SVG elements.

#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_view.hpp"
#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/layout.hpp"

#include <array>
#include <string>
#include <vector>

namespace app {

inline constexpr const char* kThrustColour = "#8aa399";
inline constexpr double kThrustWidest = 11.0; // [px] at mark_size 1

/// Colours of stones by their kind: first the wall's own, then the others, such as lintels.
inline constexpr std::array kKindTints = {"#f3ecdf", "#cfe3ee", "#e3d3ea", "#d5e8cf",
                                          "#f3d3c4"};

/// Units that are not of the wall's stone.
struct StoneTints {
    std::vector<int>
        kind; ///< of each unit, by its number - 1: place in kKindTints; missing ones are 0
    std::string name; ///< of all that are not 0: "lintels"; empty: there are none
};

[[nodiscard]] StoneTints stone_tints(const dem::Layout& layout);

/// Faint undeformed blocks.
[[nodiscard]] std::string draw_undeformed(const dem::Snapshot& wall, const WallView& view);

/// Deformed blocks; the halves of a unit look like one stone.
[[nodiscard]] std::string draw_blocks(const dem::Snapshot& wall, const WallView& view,
                                      const StoneTints& tints = {});

/// Fill of a block: grey for the beam, shades of stone that change from unit to unit, or its
/// kind.
[[nodiscard]] const char* block_tint(const dem::BlockState& block, const StoneTints& tints);

/// Lines from the centre of each block to the compression resultants of its faces, as wide as
/// their force.
/// @param widest_force drawn with kThrustWidest [N]; nothing is drawn if it is 0
[[nodiscard]] std::string draw_thrust(const dem::Snapshot& wall, const WallView& view,
                                      double widest_force);

} // namespace app
