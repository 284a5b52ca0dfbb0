#pragma once
/// Piers and spandrels of a pushed wall: forces, drift over the own height, mode, drift limits
/// of the codes. The pier that reaches its drift limit first governs the wall.

#include "app/reading/wall_reading.hpp"
#include "app/study/pushed/pier_facts.hpp"
#include "app/study/pushed/pier_history.hpp"
#include "dem/scene/mechanism/piers.hpp"
#include "dem/scene/wall.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct FragilityInput;
struct LoadInput;
struct Masonry;

struct PushedWall;

/// The drift limit of a limit state of a code for one pier.
struct PierCap {
    std::string code, state; ///< "ntc" "SLC"
    double drift = 0.0;      ///< [-]; 0: the code limits no drift of its mode
    /// Movement of the load line when the pier reaches it [m], in the direction of the push;
    /// censored where the push ended before.
    fragility::LimitDisplacement wall;
};

/// Forces and movements count in the direction of the push.
struct PierReading {
    dem::Pier pier;
    PierFacts facts;
    double drift = 0.0; ///< at the end of the push, over its own height [-]
    bool moved = false; ///< else it has no mode
    /// Whether it ever carries 5 % of the wall's largest force. Others govern nothing: the wall
    /// would hardly lose anything with them.
    bool carries = false;
    dem::FailureMode mode = dem::FailureMode::rocking;
    /// It has not come down to fragility.ultimate_share of its largest shear: `mode` is that of
    /// its mechanism so far, and may change.
    bool mode_so_far = false;
    std::vector<PierCap> caps; ///< of pier_codes(), the same of all piers of a study
    WallReading own; ///< of its shear over its own movement, with limits by its own height
};

struct SpandrelReading {
    dem::Spandrel spandrel;
    SpandrelFacts facts;
    double drift = 0.0; ///< end_drop over its length [-]
};
/// @param facts of each; empty: nothing was read of them
[[nodiscard]] std::vector<SpandrelReading>
read_spandrels(std::span<const dem::Spandrel> spandrels, std::span<const SpandrelFacts> facts);

/// Largest misses of equilibrium in the cuts through a storey, calmed(), at any curve point.
struct PierBalance {
    /// All piers against the shear at the base, over its largest [-]; NaN with body forces.
    double shear = 0.0;
    double normal = 0.0; ///< of all piers against what they carried before the push [-]
};

/// Whether the program tells piers apart: openings, and a push that goes one way.
[[nodiscard]] bool tells_piers(const Masonry& masonry, const LoadInput& load);

/// How piers are read: the rules of their wall, and the codes whose drift limits are told.
struct PierRules {
    ReadingRules wall;
    std::vector<fragility::Code> codes;
};
[[nodiscard]] PierRules pier_rules(const FragilityInput& fragility, ReadingRules rules);

/// The one place where piers are read, of a push or of the file of a study.
/// @param facts of each of these piers
/// @param wall curve as the solver wrote it
[[nodiscard]] std::vector<PierReading> read_piers(const PierRules& rules,
                                                  std::span<const dem::Pier> piers,
                                                  std::span<const PierFacts> facts,
                                                  const fragility::Curve& wall);

/// Rules for the wall of these piers: drift limits of codes are those of the pier that reaches
/// its own first.
[[nodiscard]] ReadingRules with_piers(ReadingRules rules,
                                      const std::vector<PierReading>& piers);

/// Reads the piers of a wall that was pushed, and the wall itself again, with_piers().
/// @param drop as PushPlan::drop
/// @param history of at least two points
void read_piers(const PierRules& rules, const LoadInput& load, double drop,
                const dem::PierProbe& probe, const PierHistory& history, PushedWall& wall);

/// "rocking", "rocking so far", or that it stands still, or carries nothing to speak of.
[[nodiscard]] std::string_view mode_text(const PierReading& pier);

/// Whether mode_text() is that of a pier that kept its shear to the end of the push.
[[nodiscard]] bool is_so_far(std::string_view mode);

/// Number, from 1, of the pier that reaches the drift limit of a code first, of those that
/// carry something; 0: none does.
/// @param state empty: the limit state with a drift limit, of a code that has one
[[nodiscard]] int governing_pier(const std::vector<PierReading>& piers, std::string_view code,
                                 std::string_view state = {});

/// nullptr: the code has none there.
[[nodiscard]] const PierCap* cap_of(const PierReading& pier, std::string_view code,
                                    std::string_view state = {});

} // namespace app
