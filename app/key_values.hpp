#pragma once
/// Values of the keys of a study, from and to text.

#include "app/study_keys.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace app {

/// @return in SI
/// @throws BadValue if the text is not a value of this key, or out of its range
[[nodiscard]] std::vector<double> parse_value(const Key& key, std::string_view text);

/// The value a study has, such that parse_value gives it back to the bit; empty for an empty
/// list.
[[nodiscard]] std::string value_text(const Key& key, const Study& study);

/// "[0, 90) deg", "whole or shifted"
[[nodiscard]] std::string allowed_values(const Key& key);

} // namespace app
