#pragma once
/// The one place where a wall is read: peak, ultimate displacement, limit states and failure
/// mode, off the facts of a wall (its curve and what moved) and by the rules of [fragility].
/// Every table, picture, summary, page, stopping rule and reliability analysis takes these
/// numbers. A push that turns back is read on its backbones.

#include "dem/scene/mechanism/mechanism.hpp"
#include "fragility/curve/cyclic_curve.hpp"
#include "fragility/curve/limit_states.hpp"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// A limit state of the user. Its cap is a drift, which becomes a displacement once the height
/// is known.
struct UserState {
    fragility::UserLimitState state; ///< without cap
    double most_drift = 0.0;         ///< [-]; 0: no cap
    std::string cap;                 ///< as written: "1.0 %"
};

/// A drift limit of a code by the piers of a wall.
struct PierLimit {
    /// Place of the load line when a pier first reaches its drift limit [m]; 0: the limit state
    /// has none.
    double displacement = 0.0;
    int pier = 0; ///< that pier, from 1; 0: none reached it
};

/// How walls are read. It has no influence on how a wall moves.
struct ReadingRules {
    std::vector<fragility::Code> sets; ///< codes, each once
    std::vector<UserState> user;       ///< of the set user
    fragility::LimitStateOptions options;
    dem::ModeThresholds mode;
    double height = 1.0;      ///< of the load line [m], > 0; drifts are displacements over it
    double slenderness = 1.0; ///< H0 / D, as codes take it [-], > 0
    int direction = 1;        ///< of the push: 1 to the right, -1 to the left, 0: it turns back
    fragility::Side backbone = fragility::Side::mean; ///< of a push that turns back
    double accuracy = 0.0; ///< of forces, that the solver was asked for [-]
    /// Whether the drift limits of codes are those of piers; else they follow from height and
    /// mode.
    bool by_piers = false;
    std::vector<std::vector<PierLimit>> pier_caps; ///< by set and limit state
};

/// A limit state to read, before any wall is read.
struct StateName {
    std::string set;  ///< "paper", "ntc", of a code, "user"; empty: of a table of drifts
    std::string name; ///< "SLV"; of a table its column
    std::string rule; ///< how it is read: "3/4 of SLC"
};
[[nodiscard]] std::vector<StateName> state_names(const ReadingRules& rules);
[[nodiscard]] std::string state_name(const StateName& state); ///< "ntc SLV"

/// Displacements and forces count in the direction of the push: those of a push to the left are
/// positive.
struct WallReading {
    std::string no_reading; ///< why nothing is read off the curve; empty where it is read
    std::optional<fragility::Peak> peak; ///< [N] [m]
    std::optional<double> stiffness; ///< secant at fragility::kSecantShare of the peak [N/m]
    fragility::LimitDisplacement ultimate; ///< [m]
    /// Range of `ultimate` [m]: the falls to the ultimate share of a peak that is wrong by its
    /// solver error, and at least twice the accuracy of `ultimate` to each side. It does not
    /// hold a wall that would fall on another branch.
    fragility::DropRange ultimate_range;
    fragility::LimitDisplacement collapse; ///< no force left, or the wall came down [m]
    std::vector<fragility::LimitDisplacement> limits; ///< [m], in the order of state_names
    /// By limit state the pier, from 1, whose drift limit it is, or whose it is a share of; 0:
    /// the limit is the wall's own. Empty where piers are not told apart.
    std::vector<int> governing;
    /// Readings of each backbone of a push that turns back, in the order of fragility::Side,
    /// without a mode. Mean and worse of a push that never leaves one side are those of that
    /// side.
    std::vector<WallReading> backbones;
    /// First amplitude that lies within yield [m], where that of the cycles does not: neither
    /// yield nor stiffness is read then. 0: they are.
    double begin_with = 0.0;
    dem::FailureMode mode = dem::FailureMode::rocking;
    /// The wall still stood when its push ended: `mode` is that of its mechanism so far, and
    /// may change (dem::standing_is_undecided).
    bool mode_so_far = false;
    bool dropped = false; ///< the force fell to the ultimate share of the peak
    bool slid =
        false; ///< the wall slid whole, which counts as rocking where there are two modes
};

/// @param curve as the solver wrote it, [m] and [N], of a wall that did not fail
/// @param settled whether the wall was at rest under its vertical load before it was pushed
/// @param solver_error of the peak force, as a share of it [-]; NaN: not known
[[nodiscard]] WallReading read(const fragility::Curve& curve, const dem::Mechanism& mechanism,
                               const ReadingRules& rules, bool settled = false,
                               double solver_error = std::numeric_limits<double>::quiet_NaN());

[[nodiscard]] bool same_limit(const fragility::LimitDisplacement& a,
                              const fragility::LimitDisplacement& b);

/// The smaller of each number of two walls that were read; what is not defined for one is not
/// defined. Mode and backbones are those of neither.
[[nodiscard]] WallReading worse_of(const WallReading& a, const WallReading& b);

/// The curve that limit states are read on, in its own direction: of a push that turns back a
/// backbone, of fragility::Side::worse the mean of both.
[[nodiscard]] fragility::Backbone capacity_curve(const fragility::Curve& curve,
                                                 const ReadingRules& rules);

/// A wall without a curve to read: nothing is defined.
[[nodiscard]] WallReading not_read(const ReadingRules& rules, std::string why);

/// A wall that neither overturned nor cracked nor lost load and counts as rocking
/// (ModeRule::paper).
[[nodiscard]] bool slid_whole(const dem::Mechanism& mechanism, bool dropped,
                              const dem::ModeThresholds& thresholds);

/// The mode by which drift limits of codes are chosen: one of three, whatever modes are
/// counted.
[[nodiscard]] dem::FailureMode code_mode(const dem::Mechanism& mechanism, bool dropped,
                                         const dem::ModeThresholds& thresholds);

[[nodiscard]] double peak_force(const WallReading& wall);        ///< [N]; NaN: none
[[nodiscard]] double peak_displacement(const WallReading& wall); ///< [m]; NaN: none

/// Larger distance of `ultimate` to an end of its range, as a share of it [-]; NaN: one of both
/// is not known. Where the push ended within the range, it is a lower bound.
[[nodiscard]] double ultimate_error(const WallReading& wall);

} // namespace app
