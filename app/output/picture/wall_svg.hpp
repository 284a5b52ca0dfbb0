#pragma once
/// Picture of a wall at its peak and at the end of the push: what opened, slid and cracked, and
/// where the thrust runs.

#include "app/output/picture/wall_body.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <string>

namespace app {

struct WallPictureText {
    std::string title = {};         ///< above the panels; may be empty
    std::string vertical_load = {}; ///< above the beam, e.g. "0.50 MPa"; empty: no arrows
    bool pushed = true;             ///< false: the ground moves, the force is that at the base
    double load_height = 1.10;      ///< of the horizontal load, for the drift [m], > 0
    double mark_above = 5e-4;       ///< openings and slips above this are marked [m], > 0
    std::string peak_name = "At peak";
    std::string end_name = "At the end";
    std::string both_name = "At the end, at or near the largest force";
    StoneTints tints = {};
};

/// SVG with two panels, or with one where the push ends at its largest force or within 2 % of
/// it. Displacements are drawn larger by a round factor, the same for both panels unless the
/// smaller would then not be seen; the factor is stated. Throws std::invalid_argument for a
/// wall without blocks, a length that is not positive, or a displacement that is not finite.
[[nodiscard]] std::string wall_picture(const dem::Snapshot& at_peak,
                                       const dem::Snapshot& at_end,
                                       const WallPictureText& text);

} // namespace app
