#pragma once
/// fragility/codes.json, which the program carries.

#include <string_view>

namespace fragility {

[[nodiscard]] std::string_view codes_text();

} // namespace fragility
