#pragma once
/// A measured curve as one of those that are compared.

#include "app/compare/compared.hpp"

#include <string>

namespace app {

/// Whether the name of a file is that of a table: .csv, .txt or .tsv.
[[nodiscard]] bool is_measured(const std::string& path);

/// A force against the displacement is turned round, with a note.
/// @throws ConfigError
[[nodiscard]] Compared read_measured(const std::string& path);

} // namespace app
