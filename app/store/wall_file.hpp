#pragma once
/// One HDF5 file of walls, as docs/store.md describes it: FILE.h5 and the parts beside it.

#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// Walls to write, in the order of their keys.
struct RowSource {
    std::uint64_t walls = 0;
    std::uint64_t points = 0;                  ///< of all curves
    std::function<WallRow(std::size_t)> row{}; ///< asked for 0, 1, ... walls - 1
};

/// Where the writing of a file stands; for tests that kill it there.
enum class StoreStage { rows_written, synced, renamed, parts_removed };
using StageHook = std::function<void(StoreStage)>;

/// Writes FILE.tmp, waits for the disk, renames it to `file`. Memory does not grow with the
/// number of walls. Throws StoreError; `file` is then as it was and FILE.tmp is removed.
void write_wall_file(const std::filesystem::path& file, const StoreHead& head,
                     const RowSource& source, const StageHook& reached = {});

/// Open for reading. Not to be used by several threads, as HDF5 is not.
class WallFile {
  public:
    /// None if there is no such file. Throws StoreError if it is damaged, of another layout or
    /// of something else.
    [[nodiscard]] static std::optional<WallFile> open(const std::filesystem::path& file);
    ~WallFile();
    WallFile(WallFile&&) noexcept;
    WallFile& operator=(WallFile&&) noexcept;

    [[nodiscard]] const std::filesystem::path& path() const;
    [[nodiscard]] const StoreHead& head() const;
    [[nodiscard]] const std::vector<StoredWall>& walls() const; ///< in the order of their keys
    [[nodiscard]] WallRow row(std::size_t i); ///< of walls()[i]; fastest in increasing order

  private:
    struct Impl;
    explicit WallFile(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Whether the file begins as an HDF5 file does, of a study or not, damaged or not.
[[nodiscard]] bool begins_as_hdf5(const std::filesystem::path& file);

} // namespace app
