#pragma once
/// The bytes of a drawing.

#include "app/drawing/outlines/raw_drawing.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace app {

/// @throws ConfigError if the file cannot be read, is empty or larger than 64 MB
[[nodiscard]] std::string read_drawing_bytes(const std::filesystem::path& path);

/// The text as UTF-8 without control characters: bytes that are not UTF-8 are taken as Latin-1.
/// For names of layers.
[[nodiscard]] std::string readable_name(std::string_view bytes);

/// A whole text as one number, whatever the locale. Nothing if it is none, or not finite.
[[nodiscard]] std::optional<double> read_number(std::string_view text);

} // namespace app
