#pragma once
/// The file of a study that is being run: FILE.h5, and beside it FILE.h5.parts with the walls
/// finished since, one small file per append(). Every file is only ever written as a whole and
/// then renamed, so that a kill at any moment loses at most the walls of the append() in
/// flight. Layout and guarantees: docs/store.md.

#include "app/store/hdf5/file_lock.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_parts.hpp"
#include "app/store/store_reader.hpp"
#include "app/store/store_row.hpp"
#include "app/store/wall_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace app {

struct StoreOptions {
    std::size_t most_parts = 128; ///< more are merged by append() itself; >= 1
    StageHook reached; ///< called by compact() at its stages: for tests that kill it there
};

/// Open for writing, by one process at a time. Use from one thread at a time, and not while
/// another thread uses a StoreReader. The destructor does not compact.
class Store {
  public:
    /// Creates FILE.h5 (without walls) or goes on with it and its parts, and removes what a
    /// killed process left. See continued_head for what `wanted` may change. Throws StoreError
    /// (in use: names the process; differences: shows them; damaged; disk full; read-only
    /// folder), std::invalid_argument for a bad `wanted`. Then nothing was changed.
    Store(const std::filesystem::path& file, const StoreHead& wanted,
          const StoreOptions& options = {});

    [[nodiscard]] const StoreHead& head() const { return head_; } ///< as stored now
    /// Status of a wall; none: not there, to be run. A wall just appended is there.
    [[nodiscard]] std::optional<std::int32_t> status(WallKey key) const;
    [[nodiscard]] std::size_t size() const { return walls_.size(); } ///< walls there

    /// Adds finished walls as one part: on return neither a kill nor a power cut loses them;
    /// before, none of them is there. It takes some milliseconds, so call it with many. A
    /// failed wall may be added again, it is replaced; a wall that is ok may not. Throws
    /// std::invalid_argument (sizes unlike the head, key out of range, wall there already)
    /// before anything is written; StoreError if the disk refuses: then none of `rows` is
    /// stored, all earlier walls are, and append() may be tried again. If there is no room to
    /// merge the parts they stay, and compact() says why.
    void append(std::span<const WallRow> rows);
    /// Writes all walls, sorted by key, to a new FILE.h5 in bounded memory and removes the
    /// parts. Nothing to do if there are none. Throws StoreError; all walls are there then as
    /// before.
    void compact();

  private:
    void create(const StoreHead& wanted);
    void go_on(const StoreHead& wanted);
    void add_part(const std::vector<const WallRow*>& rows);
    void merge_parts();
    void fold();

    std::filesystem::path path_;
    StoreOptions options_;
    FileLock lock_;
    StoreHead head_;
    std::map<WallKey, std::int32_t> walls_; ///< with their statuses
    std::vector<std::uint32_t> parts_;      ///< numbers, increasing
    std::size_t merge_at_;                  ///< number of parts
    std::size_t compacted_ = 0;             ///< walls in FILE.h5 since this process wrote it
};

} // namespace app
