#pragma once
/// Codes of users: fragility.codes. The page on all codes.

#include <string>

namespace app {

struct Study;

/// Reads the file or the text of fragility.codes, and keeps its text on one line, so that the
/// study stands alone.
/// @throws ConfigError at the line of the file, or at the key
void read_own_codes(Study& study);

/// docs/codes.md.
[[nodiscard]] std::string codes_page();

} // namespace app
