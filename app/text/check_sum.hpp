#pragma once
/// A short text that differs where texts do.

#include <string>
#include <string_view>

namespace app {

/// FNV-1a, 64 bits, in hexadecimal: enough to see that a text was changed, none against
/// forgery.
[[nodiscard]] std::string check_sum(std::string_view content);

} // namespace app
