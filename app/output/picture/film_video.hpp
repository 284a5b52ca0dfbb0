#pragma once
/// A film as GIF or WebM, made of pictures by ffmpeg where it is installed.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Stands at the beginning of every film of this kind.
[[nodiscard]] std::string_view video_mark(const std::filesystem::path& file);

/// Writes the film, which appears complete or not at all; its last picture is held.
/// @param stills SVG, two or more
/// @return "wall.gif written", or why there is none and what to install
[[nodiscard]] std::string write_video(const std::filesystem::path& file,
                                      const std::vector<std::string>& stills);

} // namespace app
