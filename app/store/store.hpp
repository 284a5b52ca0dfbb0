#pragma once
/// The file of a study that is being run: FILE.h5, only ever replaced as a whole, and
/// FILE.h5.journal, to which finished walls are appended. A kill at any moment loses at most the
/// walls of the append() in flight. Layout and guarantees: docs/store.md.

#include "app/store/store_error.hpp"
#include "app/store/store_file.hpp"
#include "app/store/store_head.hpp"
#include "app/store/store_reader.hpp"
#include "app/store/store_row.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace app {

struct StoreOptions {
    double sync_seconds = 1.0; ///< between waits for the disk [s], >= 0; a kill needs none, a
                               ///< power cut loses what came after the last
    /// compact() by itself when the journal is longer than this and than FILE.h5 [bytes]
    std::uint64_t journal_bytes = 64u << 20;
    StageHook reached; ///< called by compact() at its stages: for tests that kill it there
};

/// Open for writing, by one process at a time. Use from one thread at a time, and not while
/// another thread uses a StoreReader. The destructor neither compacts nor throws.
class Store {
  public:
    /// Creates FILE.h5 (without walls) or goes on with it: replays the journal, cuts a torn record
    /// off, removes what a killed compaction left. See continued_head for what `wanted` may change.
    /// Throws StoreError (in use: names the process; differences: shows them; damaged; disk full;
    /// read-only folder), std::invalid_argument for a bad `wanted`. Then nothing was changed.
    Store(std::filesystem::path file, const StoreHead& wanted,
          const StoreOptions& options = {});
    ~Store();
    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;

    [[nodiscard]] const StoreHead& head() const;        ///< as stored now
    [[nodiscard]] const JournalState& replayed() const; ///< what opening found in the journal
    /// Status of a wall; none: not there, to be run. A wall just appended is there.
    [[nodiscard]] std::optional<std::int32_t> status(WallKey key) const;
    [[nodiscard]] std::vector<WallStatus> statuses() const; ///< in the order of keys
    [[nodiscard]] std::size_t size() const;                 ///< walls there

    /// Adds finished walls: on return no kill loses them; a kill before may keep the first of
    /// them. A failed wall may be added again, it is replaced; a wall that is ok may not.
    /// Compacts when the journal has grown long.
    /// Throws std::invalid_argument (sizes unlike the head, key out of range, wall there already)
    /// before anything is written; StoreError if the disk refuses: then none of `rows` is in the file,
    /// all earlier walls are, and append() may be tried again. If the compaction by itself fails the
    /// walls are kept, the journal goes on growing, and compact() says why.
    void append(std::span<const WallRow> rows);
    /// Waits until the disk has all walls.
    void sync();
    /// Writes all walls, sorted by key, to a new FILE.h5 in bounded memory and removes the journal.
    /// Nothing to do if there is no journal. Throws StoreError; FILE.h5 and journal then are as before.
    void compact();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace app
