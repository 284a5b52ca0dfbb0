#pragma once
/// What a study found, at a glance: one row per stress level. The tables proper come from its curves.

#include "app/output/table.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace app {

struct StudySummary {
    Table table;
    std::string remarks; ///< lines: walls that failed and why, walls still to run
    std::size_t failed = 0, missing = 0;
};

/// @throws StoreError
[[nodiscard]] StudySummary summarise(const std::filesystem::path& file);

} // namespace app
