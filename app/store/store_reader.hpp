#pragma once
/// Reads a stored study: FILE.h5 and the parts beside it, changing neither.

#include "app/store/hdf5/store_error.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_row.hpp"
#include "app/store/wall_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace app {

/// A snapshot: walls added later are not seen. Needs no lock and no write permission, works
/// while a study runs. HDF5 is not called by several threads: use from one thread at a time,
/// and not while another thread uses any other reader or Store.
class StoreReader {
  public:
    /// Reads all keys. Of walls with one key the last part's counts.
    /// Throws StoreError if there is no such file, if it is damaged, of another layout or of
    /// something else, or if a part beside it belongs to another study.
    explicit StoreReader(const std::filesystem::path& file);
    /// Several of one study as one, at least one. Of walls with one key the last reader's
    /// counts.
    explicit StoreReader(std::vector<StoreReader> several);

    [[nodiscard]] const StoreHead& head() const;
    /// All walls in the order of their keys; what row(i) counts.
    [[nodiscard]] const std::vector<WallStatus>& statuses() const { return statuses_; }

    /// Wall i of statuses(), i in [0, statuses().size()); fastest in increasing order.
    [[nodiscard]] WallRow row(std::size_t i);
    /// The file that wall i is in: FILE.h5 or a part.
    [[nodiscard]] const std::filesystem::path& file_of(std::size_t i) const;
    /// The wall of this key, if it is there.
    [[nodiscard]] std::optional<WallRow> row(WallKey key);
    /// All walls of the study in the order of their keys, one in memory at a time; those of its
    /// audit and of the other direction are left out.
    void for_each_row(const std::function<void(const WallRow&)>& visit);
    /// The same of the other direction.
    void for_each_turned_row(const std::function<void(const WallRow&)>& visit);
    /// The same of its audit.
    void for_each_audit_row(const std::function<void(const WallRow&)>& visit);
    /// All of them, to be written; must not outlive this.
    [[nodiscard]] RowSource walls();

  private:
    /// Where a wall is.
    struct Place {
        StoredWall wall;
        std::uint32_t file = 0, row = 0;
    };
    explicit StoreReader(std::vector<WallFile> files);
    void visit_rows(Round round, const std::function<void(const WallRow&)>& visit);
    static std::vector<WallFile> files_of(std::vector<StoreReader> several);

    std::vector<WallFile> files_;
    std::vector<Place> places_;
    std::vector<WallStatus> statuses_;
};

/// Head alone, at the cost of opening.
[[nodiscard]] StoreHead read_head(const std::filesystem::path& file);

/// Walls of `head` that are missing in `there`, which is in the order of keys; for a shard, of
/// the whole study.
[[nodiscard]] std::vector<WallKey> missing_walls(const StoreHead& head,
                                                 const std::vector<WallStatus>& there);

} // namespace app
