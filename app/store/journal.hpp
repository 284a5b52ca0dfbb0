#pragma once
/// FILE.h5.journal: finished walls, appended and never changed.
///
/// 24 bytes of preamble (`drystone-journal`, layout, CRC-32 of the 20 bytes before), then records:
/// mark "DREC", kind, length, CRC-32 of the payload, CRC-32 of the 20 bytes before; then the
/// payload. All little endian.

#include "app/store/store_disk.hpp"
#include "app/store/store_reader.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace app {

enum class RecordKind : std::uint32_t { head = 1, wall = 2 };

/// One whole record is `bytes` + kRecordHeader long.
constexpr std::size_t kRecordHeader = 24;
constexpr std::size_t kJournalPreamble = 24;

/// Adds a record to a batch that Journal::append writes.
void put_record(std::string& batch, RecordKind kind, std::string_view payload);

/// Visits all sound records in order; `offset` is that of the payload. A record that is not sound is
/// skipped if a sound one follows, and is a torn end if none does. JournalState::bytes is where
/// Journal goes on, 0 if not even the preamble is whole.
/// Throws StoreError: no journal, or of another layout; and what `visit` throws.
[[nodiscard]] JournalState scan_journal(
    const OpenFile& file, const std::filesystem::path& path,
    const std::function<void(RecordKind, std::uint64_t offset, std::string_view)>& visit);

/// Open for appending, by the holder of the lock.
class Journal {
  public:
    /// Goes on after byte `end` and cuts off what is behind it; 0: anew, with the preamble.
    /// Throws StoreError; the sound records are untouched then.
    Journal(std::filesystem::path path, std::uint64_t end, double sync_seconds);

    /// Writes the batch by one system call and waits for the disk if `sync_seconds` have passed.
    /// Throws StoreError; the journal then ends where it ended before.
    void append(std::string_view batch);
    /// Waits for the disk if anything is new. Throws StoreError.
    void sync();
    [[nodiscard]] std::uint64_t length() const { return end_; } ///< [bytes]

  private:
    void cut_back() const;

    std::filesystem::path path_;
    OpenFile file_;
    std::uint64_t end_ = 0;
    double sync_seconds_;
    bool unsynced_ = false;
    std::chrono::steady_clock::time_point synced_at_; ///< moves no result
};

} // namespace app
