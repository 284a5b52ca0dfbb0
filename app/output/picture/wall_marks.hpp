#pragma once
/// Marks of what a push did to the joints and units of a wall, drawn on it: openings, slips,
/// cracks. Each function gives SVG elements.

#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_view.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <string>

namespace app {

/// Sizes that marks share, so that two panels compare.
struct MarkSizes {
    double threshold = 5e-4;  ///< openings and slips up to this are not marked [m], > 0
    double widest_slip = 0.0; ///< [m], drawn with kSlipWidest; > 0 if a slip is marked
    bool crushed = false;     ///< whether a contact is marked as crushed
};

inline constexpr const char* kCrackColour = "#c8102e";
inline constexpr const char* kOpeningColour = "#2166ac";
inline constexpr const char* kGapColour = "#6aa5d6"; // inside an opening
inline constexpr const char* kSlipColour = "#e08214";
inline constexpr const char* kCrushColour = "#5e2a84";
inline constexpr double kSlipThinnest = 1.5, kSlipWidest = 7.0; // [px] at mark_size 1

/// Filled gaps of joints.
[[nodiscard]] std::string draw_openings(const dem::Snapshot& wall, const WallView& view,
                                        const MarkSizes& sizes);

/// Lines along joints that slid while closed, wider with slip, with a pair of half-arrows on
/// the larger ones.
[[nodiscard]] std::string draw_slips(const dem::Snapshot& wall, const WallView& view,
                                     const MarkSizes& sizes);

/// Cracks through units: gap and solid line where every contact has D = 1, dashes over damaged
/// contacts elsewhere.
[[nodiscard]] std::string draw_cracks(const dem::Snapshot& wall, const WallView& view);

/// A square at each contact that has begun to crush, filled as far as its strength is lost.
[[nodiscard]] std::string draw_crushed(const dem::Snapshot& wall, const WallView& view);

/// The square. @param lost share of the strength [-]
[[nodiscard]] std::string crushed_mark(Pixel at, double lost, double size);

/// Half-arrows on both sides of a joint through `at`: the side that `left` (unit vector,
/// pixels) points to moves along `along` (unit vector, pixels), the other side against it.
/// @param size WallView::mark_size
[[nodiscard]] std::string half_arrows(Pixel at, Pixel along, Pixel left, double size);

} // namespace app
