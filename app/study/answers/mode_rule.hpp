#pragma once
/// The rules by which walls are read, in words.

#include <string>

namespace app {

struct FragilityInput;
struct LoadInput;

/// "force first comes down to 80 % of the peak"
[[nodiscard]] std::string ultimate_text(const FragilityInput& f);

/// " The push goes to and fro; values are read on the mean of the backbones of both
/// directions."; empty of a push that goes one way.
[[nodiscard]] std::string backbone_text(const LoadInput& load, const FragilityInput& fragility);

/// Walls whose mode is not decided: "walls that failed or still stood".
[[nodiscard]] std::string undecided_text(const FragilityInput& f);

/// Condition under which the interval of a share of a mode (mode_share.hpp) holds: "whatever
/// mode the walls that failed would have had in the end".
[[nodiscard]] std::string whatever_mode_text(const FragilityInput& f);

/// "Mixed: ...; otherwise rocking", with the thresholds; no full stop.
[[nodiscard]] std::string mode_rule_text(const FragilityInput& f);

} // namespace app
