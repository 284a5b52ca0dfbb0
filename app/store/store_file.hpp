#pragma once
/// FILE.h5, written complete or not at all.

#include "app/store/store_head.hpp"
#include "app/store/store_reader.hpp"
#include "app/store/store_row.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>

namespace app {

/// Walls in the order of their keys.
struct RowSource {
    StoreSize size;
    std::function<WallRow(std::size_t)> row; ///< asked for 0, 1, ... size.walls - 1
};

/// Where the writing of FILE.h5 stands; for tests that kill it there.
enum class StoreStage { rows_written, sealed, synced, renamed, journal_removed };
using StageHook = std::function<void(StoreStage)>;

/// Writes FILE.h5.part, waits for the disk, renames it to `file`. Memory does not grow with the number
/// of walls. Throws StoreError; `file` is then as it was and the part is removed.
void replace_study_file(const std::filesystem::path& file, const StoreHead& head,
                        const RowSource& source, const StageHook& reached = {});

[[nodiscard]] std::filesystem::path part_of(const std::filesystem::path& file);
[[nodiscard]] std::filesystem::path journal_of(const std::filesystem::path& file);
[[nodiscard]] std::filesystem::path lock_of(const std::filesystem::path& file);

} // namespace app
