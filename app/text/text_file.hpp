#pragma once
/// Reading a whole file, telling text from other bytes, and where a file is.

#include <cstddef>
#include <string>
#include <string_view>

namespace app {

/// The bytes of a file.
/// @param most [bytes]; a larger file is refused with the words `too_large`
/// @param remedy what to give in place of a path that cannot be read
/// @throws ConfigError
[[nodiscard]] std::string read_bytes(const std::string& path, std::size_t most,
                                     const std::string& too_large, const std::string& remedy);

/// The bytes of a study file of at most 1 MiB.
/// @throws ConfigError if the path is a directory, cannot be read or is larger
[[nodiscard]] std::string read_small_file(const std::string& path);

/// The whole path of a file; empty where none is.
[[nodiscard]] std::string whole_path(const std::string& file);

/// Well-formed UTF-8 without NUL.
[[nodiscard]] bool is_text(std::string_view bytes);

} // namespace app
