#pragma once
/// What 1 % of the peak force costs, here and with the paper's own scheme.

#include <string>

namespace bench {

/// Runs both on the mean-value walls, faster than needed at first, then at half the speed until the
/// error of the peak stays within 1 %; a section of Markdown. Minutes.
[[nodiscard]] std::string equal_error_text();

} // namespace bench
