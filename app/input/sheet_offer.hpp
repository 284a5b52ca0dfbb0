#pragma once
/// The line that offers the sheet of a wall or a study.

#include <filesystem>
#include <span>
#include <string>

namespace app {

/// "one page to print: drystone sheet runs/house.h5"; the name of the sheet is added where it
/// would not lie beside `read`.
/// @param read the study file or the FILE.h5 that the sheet is made of
/// @param title of the sheet; empty: the name of `read`
/// @param stresses of the walls [Pa]; of several the sheet is that of the first
[[nodiscard]] std::string sheet_offer(const std::filesystem::path& read,
                                      const std::string& title,
                                      std::span<const double> stresses);

} // namespace app
