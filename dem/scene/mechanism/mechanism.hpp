#pragma once
/// Numbers that tell how a wall has moved, read from its final state, and the rule that names
/// its failure mode from them.

#include "dem/scene/geometry/snapshot.hpp"

#include <array>
#include <string_view>

namespace dem {

struct Mechanism {
    /// Rotation of the beam x height / displacement [-]; 1 for a wall that turns about its toe
    /// as one body. Without a beam that of the blocks, with their signs.
    double rotation_share = 0.0;
    /// Slip of the closed bed joints, summed over the courses, / displacement [-].
    double sliding_share = 0.0;
    /// Units that are cracked through: without the cracks whose contacts all have D = 1, no
    /// part is larger than kLargestPart of the unit.
    int cracked_units = 0;
    int cracked_contacts = 0; ///< contacts of cracks with D = 1
    int spalled_units = 0;    ///< units not cracked through that have lost smaller parts
    int crushed_contacts = 0; ///< contacts of joints and cracks that have begun to crush
    /// Area of contacts that have lost all their compressive strength [m2].
    double crushed_area = 0.0;
    /// Rotation of the blocks x height / displacement [-] (rotation_share.hpp); 1 too for piers
    /// that rock below a spandrel and for a wall in double bending. Rotations to either side
    /// count where they cancel and bed joints do not slide, as in an arch on its hinges.
    double turning_share = 0.0;
};

/// Largest part of the area of a unit that is cracked through [-]. Smaller parts that break off
/// are spalls.
constexpr double kLargestPart = 0.75;

/// @param height of the load line above the floor [m], > 0
[[nodiscard]] Mechanism mechanism(const Snapshot& wall, double height);

/// The same wall later, as if it had begun to move at `from`: displacements and slips are those
/// since then, all else is that of `to`.
[[nodiscard]] Snapshot movement_since(const Snapshot& from, Snapshot to);

enum class FailureMode {
    rocking, ///< the wall overturns
    sliding, ///< it moves along its joints, and its units stay whole
    mixed    ///< diagonal shear: units crack and bed joints slide
};

/// Names in the order of FailureMode.
inline constexpr std::array<std::string_view, 3> kModeNames = {"rocking", "sliding", "mixed"};
[[nodiscard]] constexpr std::string_view name(FailureMode mode)
{
    return kModeNames[static_cast<int>(mode)];
}

/// Rule that tells the modes apart.
enum class ModeRule {
    paper, ///< two modes: walls that slide whole count as rocking, all that lose load as mixed
    mechanism ///< rocking, sliding, mixed: by what moves first, by what cracks second
};

/// Thresholds of the rule; they are the same for all stress levels. They are our choice,
/// because the paper tells the modes apart by inspection. docs/model.md gives the reasons,
/// docs/validation.md the effect.
struct ModeThresholds {
    double rotation_share = 0.5; ///< a wall below this share does not overturn [-], in (0, 1)
    /// A wall with so many units cracked through counts as cracked, >= 0; with 0, sliding is
    /// enough.
    int cracked_units = 1;
    ModeRule modes = ModeRule::mechanism;
};

/// Whether the mode of a wall that still stands is that of its mechanism so far, and may
/// change. As the paper has it, a wall that stands rocks.
[[nodiscard]] constexpr bool standing_is_undecided(const ModeThresholds& t)
{
    return t.modes == ModeRule::mechanism;
}

/// Whether at least the given share of the displacement is rotation, of the beam or of the
/// blocks: such a wall does not slide.
[[nodiscard]] bool rocks(const Mechanism& m, const ModeThresholds& t = {});

/// By mechanism: rocking if at least the given share of the displacement is rotation of the
/// beam, whatever cracked and whether or not the load dropped; else mixed if units cracked
/// through; else rocking, or sliding if rocks() says no. As the paper: mixed if the load
/// dropped (80 % rule), or if units cracked through and less than the given share of the
/// displacement is rotation of the beam. Otherwise it is rocking (paper, section 4.2: "the
/// mixed-mode involves the cracking in the units and sliding in the bed-joints", the drop "is
/// not present in the rocking mechanism", rocking leaves "localized damage at the corners").
[[nodiscard]] FailureMode failure_mode(const Mechanism& m, bool load_dropped,
                                       const ModeThresholds& t = {});

} // namespace dem
