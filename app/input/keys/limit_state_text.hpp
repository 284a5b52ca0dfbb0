#pragma once
/// How the walls of a study are read: [fragility] as rules.

#include "app/reading/wall_reading.hpp"

#include <string_view>
#include <vector>

namespace app {

struct FragilityInput;
struct Study;

/// "slight: 0.7 yield; heavy: 0.5 yield + 0.5 ultimate; crack: rise 0.33; half: drop 0.5; near:
/// ultimate or 1.0 %; far: 2 %". A drift after `or` is a cap: whichever comes first.
/// @throws std::invalid_argument naming the state and what is allowed
[[nodiscard]] std::vector<UserState> parse_user_states(std::string_view text);

/// All codes that a study can name: those of the program, and those of fragility.codes.
[[nodiscard]] std::vector<fragility::Code> known_codes(const FragilityInput& fragility);

/// Codes whose drift limits are told of each pier: ntc and ec8, and those the study asks for.
[[nodiscard]] std::vector<fragility::Code> pier_codes(const FragilityInput& fragility,
                                                      const ReadingRules& rules);

/// read_study has asked for it: a study that was read has rules.
/// @throws ConfigError at the key to change
[[nodiscard]] ReadingRules reading_rules(const Study& study);

} // namespace app
