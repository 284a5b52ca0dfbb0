#pragma once
/// Reads a stored study: FILE.h5 and the walls that still are in its journal, changing neither.

#include "app/store/store_error.hpp"
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

/// What the journal of an unfinished study held.
struct JournalState {
    std::uint64_t bytes = 0;   ///< up to the end of the last sound record; 0: no journal
    std::uint64_t records = 0; ///< whole and sound
    std::uint64_t damaged = 0; ///< skipped: their checksum is wrong; these walls are run again
    std::uint64_t torn_bytes = 0; ///< unfinished record at the end, left by a kill
};

/// Totals over all walls.
struct StoreSize {
    std::uint64_t walls = 0;
    std::uint64_t points = 0;       ///< of their curves
    std::uint64_t reason_bytes = 0; ///< of the longest reason
};

/// A snapshot: walls added later are not seen. Needs no lock and no write permission, works while
/// a study runs. HDF5 is not called by several threads: use from one thread at a time, and not
/// while another thread uses any other reader or Store.
class StoreReader {
  public:
    /// Reads the whole file once for its checksum (about 1 GB/s), then all keys.
    /// Throws StoreError if there is no such file, if it is damaged, of another layout or of
    /// something else, or if the journal beside it belongs to another study.
    explicit StoreReader(const std::filesystem::path& file);
    ~StoreReader();
    StoreReader(StoreReader&&) noexcept;
    StoreReader& operator=(StoreReader&&) noexcept;

    [[nodiscard]] const StoreHead& head() const;
    [[nodiscard]] const JournalState& journal() const;
    [[nodiscard]] const StoreSize& size() const;
    /// All walls in the order of their keys; what row(i) counts.
    [[nodiscard]] const std::vector<WallStatus>& statuses() const;

    /// Wall i of statuses(), i in [0, statuses().size()); fastest in increasing order.
    [[nodiscard]] WallRow row(std::size_t i);
    /// The wall of this key, if it is there.
    [[nodiscard]] std::optional<WallRow> row(WallKey key);
    /// All walls in the order of their keys, one in memory at a time.
    void for_each_row(const std::function<void(const WallRow&)>& visit);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Head alone, at the cost of opening.
[[nodiscard]] StoreHead read_head(const std::filesystem::path& file);

/// Walls of `head` of which `there` (in the order of keys) has none; of a shard, too, all of the study.
[[nodiscard]] std::vector<WallKey> missing_walls(const StoreHead& head,
                                                 const std::vector<WallStatus>& there);

} // namespace app
