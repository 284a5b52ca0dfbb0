#pragma once
/// Values of the keys of a study, from and to text.

#include "app/input/keys/study_keys.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// @return in SI
/// @throws BadValue if the text is not a value of this key, or out of its range
[[nodiscard]] std::vector<double> parse_value(const Key& key, std::string_view text);

/// The value as a distribution, cut off at the range of the key; nothing if it is a number.
/// @throws BadValue if it is meant as one and is none, if the key takes none, or if the range
/// of the
/// key holds less than half of it
[[nodiscard]] std::optional<RandomInput> parse_random(const Key& key, std::string_view text);

/// The value a study has, such that parse_value gives it back to the bit; empty for an empty
/// list.
[[nodiscard]] std::string value_text(const Key& key, const Study& study);

/// Whether a number lies in the range of its key.
[[nodiscard]] bool in_range(double si, const Key& key);

/// "[0, 90) deg", "whole or shifted"
[[nodiscard]] std::string allowed_values(const Key& key);

/// "required", the rule by which it follows from others, or the value.
[[nodiscard]] std::string default_text(const Key& key);

} // namespace app
