#pragma once
/// The study that a file of results says it holds.

#include "app/input/study_reading.hpp"
#include "app/store/store_head.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace app {

/// The study of the stored configuration, once that is known to be the one whose walls are in
/// the file: stresses and seed are those of the head; identity too, where the same version of
/// the program wrote it (another version may have had other keys).
/// @param overrides section.key=value, put in place of the stored values afterwards
/// @throws BadStoredStudy naming the file and the lines that differ, ConfigError
[[nodiscard]] Study stored_study(const std::filesystem::path& file, const StoreHead& head,
                                 std::span<const std::string> overrides = {},
                                 Purpose purpose = Purpose::push);

} // namespace app
