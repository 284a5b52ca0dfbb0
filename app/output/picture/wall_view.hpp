#pragma once
/// From a deformed wall to pixels.

#include "app/output/picture/svg_elements.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <span>

namespace app {

/// Corners of a box [m].
struct WallBox {
    dem::Point low, high;
};

/// How a wall is put on the page.
struct WallView {
    double scale = 1.0;            ///< displacements are drawn this many times larger [-]
    double pixels_per_metre = 1.0; ///< > 0
    Pixel origin;                  ///< of x = 0, z = 0
    double mark_size = 1.0;        ///< of lines and arrows, smaller where stones are small [-]

    /// Where point `at`, displaced by `u`, is drawn.
    [[nodiscard]] Pixel place(dem::Point at, dem::Point u = {}) const;
};

/// The two sides of a contact and the middle between them, as drawn.
struct ContactPixels {
    Pixel a, b, middle;
};

/// Box of blocks displaced by `scale` times their displacement; 0: undeformed.
/// Throws std::invalid_argument if there are no blocks or their size is zero or not finite.
[[nodiscard]] WallBox box_of(std::span<const dem::BlockState> blocks, double scale);

/// Smallest box around both.
[[nodiscard]] WallBox join(const WallBox& a, const WallBox& b);

/// The round factor (1, 2, 3, 5, 10, ...) at which a mechanism is seen and the wall is still a
/// wall: the largest displacement is drawn below 0.15, and the largest opening or slip below
/// 0.12, of the smaller side of the wall. In [1, 1000].
[[nodiscard]] double drawing_scale(const dem::Snapshot& wall);

[[nodiscard]] ContactPixels place_contact(const dem::Snapshot& wall, const WallView& view,
                                          const dem::FaceState& face,
                                          const dem::ContactState& contact);

} // namespace app
