#pragma once
/// What happened to a wall, in words: the only place that has them.

#include "dem/scene/mechanism.hpp"
#include "dem/solver/push.hpp"
#include "fragility/curve_reading.hpp"

#include <array>
#include <string_view>

namespace app {

/// In the order of dem::FailureMode.
inline constexpr std::array<std::string_view, 3> kModes = {"rocking", "sliding", "mixed"};

/// In the order of fragility::Side.
inline constexpr std::array<std::string_view, 4> kSides = {"mean", "worse", "right", "left"};

/// In the order of dem::Outcome.
inline constexpr std::array<std::string_view, 7> kOutcomes = {
    "reached target", "decided",      "lost equilibrium", "not finite",
    "energy astray",  "out of steps", "no wall"};

[[nodiscard]] std::string_view words(dem::FailureMode mode); ///< "rocking", "sliding", "mixed"
[[nodiscard]] std::string_view
words(fragility::Reading reading);                          ///< "observed", "censored", ...
[[nodiscard]] std::string_view words(dem::Outcome outcome); ///< "reached target", ...

/// Of an outcome that is a failure: what went wrong.
[[nodiscard]] std::string_view why_failed(dem::Outcome outcome);

} // namespace app
