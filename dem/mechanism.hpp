#pragma once
/// What a wall did, as numbers read off its last state, and the failure mode as a rule on them.

#include "dem/snapshot.hpp"

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
    rocking, ///< rotation about the toe, joints open in steps, no unit breaks, the load is kept
    mixed    ///< units crack or courses slide (diagonal shear)
};

/// Thresholds of the rule, the same for all stress levels. Free choices; docs/model.md has
/// their effect.
struct ModeThresholds {
    double sliding_share = 0.25; ///< from here on a wall counts as sliding [-], in (0, 1)
    int cracked_units = 1;       ///< from here on a wall counts as cracked, >= 1
};

/// Mixed if units cracked through, or the load dropped (80 % rule), or the courses slid; else
/// rocking.
[[nodiscard]] FailureMode failure_mode(const Mechanism& m, bool load_dropped,
                                       const ModeThresholds& t = {});

} // namespace dem
