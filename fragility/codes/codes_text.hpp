#pragma once
/// fragility/codes/codes.json, which the program carries.

#include <string_view>

namespace fragility {

[[nodiscard]] std::string_view codes_text();

} // namespace fragility
