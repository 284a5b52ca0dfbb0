#pragma once
/// The rule that names failure modes, in words.

#include "dem/scene/mechanism.hpp"

#include <string>

namespace app {

/// "Mixed: ...; else rocking", with the thresholds; no full stop.
[[nodiscard]] std::string mode_rule_text(const dem::ModeThresholds& t);

/// A wall that neither overturned nor cracked nor lost load: the rule counts it as rocking.
[[nodiscard]] bool slid_whole(const dem::Mechanism& m, bool load_dropped,
                              const dem::ModeThresholds& t);

} // namespace app
