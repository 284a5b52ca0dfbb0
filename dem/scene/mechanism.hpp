#pragma once
/// What a wall did, as numbers read off its last state, and the failure mode as a rule on them.

#include "dem/scene/snapshot.hpp"

namespace dem {

struct Mechanism {
    double rotation_share =
        0.0; ///< rotation of the beam x height / displacement [-]: 1 for a wall that only rocks
    double sliding_share =
        0.0; ///< slip of the closed bed joints, summed over the courses / displacement [-]
    int cracked_units = 0;    ///< units cracked through: D = 1 in all contacts of the crack
    int cracked_contacts = 0; ///< contacts in units with D = 1
};

/// @param height of the load line above the floor [m], > 0
[[nodiscard]] Mechanism mechanism(const Snapshot& wall, double height);

enum class FailureMode {
    rocking, ///< the wall overturns and keeps its load; also one that slides along a course whole
    mixed    ///< diagonal shear: units crack and bed joints slide
};

/// Thresholds of the rule, the same for all stress levels. Free choices: the paper tells the modes
/// apart by inspection. docs/model.md has the grounds, docs/validation.md the effect.
struct ModeThresholds {
    double rotation_share = 0.5; ///< below it a wall does not overturn [-], in (0, 1)
    int cracked_units =
        1; ///< from here on a wall counts as cracked, >= 0; 0: sliding is enough
};

/// Mixed if the load dropped (80 % rule), or units cracked through and less than the given share of
/// the displacement is rotation; else rocking (paper, section 4.2: "the mixed-mode involves the
/// cracking in the units and sliding in the bed-joints", the drop "is not present in the rocking
/// mechanism", rocking leaves "localized damage at the corners").
[[nodiscard]] FailureMode failure_mode(const Mechanism& m, bool load_dropped,
                                       const ModeThresholds& t = {});

} // namespace dem
