#pragma once
/// Reading a whole file, and telling text from other bytes.

#include <string>
#include <string_view>

namespace app {

/// The bytes of a file of at most 1 MiB.
/// @throws ConfigError if the path is a directory, cannot be read or is larger
[[nodiscard]] std::string read_small_file(const std::string& path);

/// Well-formed UTF-8 without NUL.
[[nodiscard]] bool is_text(std::string_view bytes);

} // namespace app
