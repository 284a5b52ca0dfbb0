#pragma once
/// The rules by which walls are read, in words.

#include "app/input/study.hpp"

#include <string>

namespace app {

/// "force first comes down to 80 % of the peak"
[[nodiscard]] std::string ultimate_text(const FragilityInput& f);

/// "Mixed: ...; else rocking", with the thresholds; no full stop.
[[nodiscard]] std::string mode_rule_text(const FragilityInput& f);

} // namespace app
