#pragma once
/// Rules and drifts of a table of codes as text.

#include "fragility/codes/code.hpp"

#include <string_view>

namespace fragility {

/// "yield", "0.7 yield", "yield or peak", "peak", "ultimate", "collapse", "rise 0.33",
/// "drop 0.5", "3/4 SLC": a share of another limit state, whose name goes to `of_name`.
/// @throws std::invalid_argument
void read_rule(std::string_view text, CodeState& state);

/// The words of rules, for messages.
[[nodiscard]] std::string_view rule_words();

/// "1 %", "0.8 % H0/D"
/// @throws std::invalid_argument
[[nodiscard]] CodeDrift drift_of_text(std::string_view text);

/// "0.75", "3/4"
/// @throws std::invalid_argument
[[nodiscard]] double positive_number(std::string_view text);

/// Letters, digits and _ alone.
[[nodiscard]] bool is_name(std::string_view text);

} // namespace fragility
