#include "app/store/journal.hpp"

#include "app/store/store_error.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <unistd.h>

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "drystone-journal";
constexpr std::string_view kMark = "DREC";

template <class T> T value_at(std::string_view bytes, std::size_t offset)
{
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

void put_number(std::string& bytes, std::uint64_t value, std::size_t size)
{
    bytes.append(reinterpret_cast<const char*>(&value), size);
}

std::string preamble()
{
    std::string bytes(kMagic);
    put_number(bytes, kStoreLayout, 4);
    put_number(bytes, crc32_of(bytes), 4);
    return bytes;
}

struct RecordHeader {
    RecordKind kind;
    std::uint64_t size; ///< of the payload [bytes]
    std::uint32_t sum;  ///< of the payload
};

/// None if the bytes are no sound header of a record that ends within `space` bytes.
std::optional<RecordHeader> header_of(std::string_view bytes, std::uint64_t space)
{
    if (bytes.size() < kRecordHeader || bytes.substr(0, 4) != kMark) return {};
    if (crc32_of(bytes.substr(0, 20)) != value_at<std::uint32_t>(bytes, 20)) return {};
    const RecordHeader header{RecordKind{value_at<std::uint32_t>(bytes, 4)},
                              value_at<std::uint64_t>(bytes, 8),
                              value_at<std::uint32_t>(bytes, 16)};
    if (space < kRecordHeader || header.size > space - kRecordHeader) return {};
    return header;
}

/// The journal, read record by record.
class Scan {
  public:
    Scan(const OpenFile& file, const fs::path& path)
        : file_(file), path_(path), length_(file_length(file, path))
    {
    }

    std::uint64_t length() const { return length_; }

    /// Payload of a sound record at `offset`, none if there is no such thing.
    std::optional<RecordHeader> record(std::uint64_t offset, std::string& payload) const
    {
        std::array<char, kRecordHeader> bytes{};
        const std::size_t n = read_at(file_, path_, bytes.data(), bytes.size(), offset);
        const auto header = header_of({bytes.data(), n}, length_ - offset);
        if (!header) return {};
        payload.resize(static_cast<std::size_t>(header->size));
        if (read_at(file_, path_, payload.data(), payload.size(), offset + kRecordHeader) !=
                payload.size() ||
            crc32_of(payload) != header->sum)
            return {};
        return header;
    }

    /// Where the next sound record begins at or after `from`; length() if nowhere.
    std::uint64_t next(std::uint64_t from) const
    {
        constexpr std::size_t window = 1 << 20;
        std::string bytes, payload;
        while (from < length_) {
            bytes.resize(window);
            bytes.resize(read_at(file_, path_, bytes.data(), window, from));
            for (std::size_t k = bytes.find(kMark); k != std::string::npos;
                 k = bytes.find(kMark, k + 1))
                if (record(from + k, payload)) return from + k;
            if (bytes.size() < window) break;
            from += window - (kMark.size() - 1); // a mark across two windows
        }
        return length_;
    }

  private:
    const OpenFile& file_;
    const fs::path& path_;
    std::uint64_t length_;
};

/// Whether the preamble is whole. Throws if the file begins with something else.
bool has_preamble(const OpenFile& file, const fs::path& path)
{
    std::array<char, kJournalPreamble> bytes{};
    const std::size_t n = read_at(file, path, bytes.data(), bytes.size(), 0);
    const std::string_view found(bytes.data(), n);
    const std::string wanted = preamble();
    if (found == wanted) return true;
    if (n < wanted.size() && wanted.compare(0, n, found) == 0) return false; // torn at creation
    const bool sound = n == wanted.size() && found.substr(0, kMagic.size()) == kMagic &&
                       crc32_of(found.substr(0, 20)) == value_at<std::uint32_t>(found, 20);
    if (sound)
        throw StoreError("'" + path.string() + "' has layout " +
                         std::to_string(value_at<std::uint32_t>(found, 16)) +
                         ", this program knows " + std::to_string(kStoreLayout) +
                         "; go on with the version of the program that wrote it");
    throw StoreError("'" + path.string() +
                     "' is damaged or no journal of a study; move it away: its walls, those "
                     "since the last compaction, are run again");
}

} // namespace

void put_record(std::string& batch, RecordKind kind, std::string_view payload)
{
    std::string header(kMark);
    put_number(header, static_cast<std::uint32_t>(kind), 4);
    put_number(header, payload.size(), 8);
    put_number(header, crc32_of(payload), 4);
    put_number(header, crc32_of(header), 4);
    batch += header;
    batch += payload;
}

JournalState
scan_journal(const OpenFile& file, const fs::path& path,
             const std::function<void(RecordKind, std::uint64_t, std::string_view)>& visit)
{
    JournalState found;
    const Scan scan(file, path);
    if (!has_preamble(file, path)) {
        found.torn_bytes = scan.length();
        return found;
    }
    std::uint64_t offset = kJournalPreamble;
    found.bytes = offset;
    std::string payload;
    while (offset < scan.length()) {
        if (const auto header = scan.record(offset, payload)) {
            visit(header->kind, offset + kRecordHeader, payload);
            ++found.records;
            offset += kRecordHeader + header->size;
            found.bytes = offset;
            continue;
        }
        offset = scan.next(offset + 1);
        if (offset < scan.length()) ++found.damaged;
    }
    found.torn_bytes = scan.length() - found.bytes;
    return found;
}

Journal::Journal(fs::path path, std::uint64_t end, double sync_seconds)
    : path_(std::move(path)), end_(end), sync_seconds_(sync_seconds),
      synced_at_(std::chrono::steady_clock::now())
{
    file_ = OpenFile(::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (!file_.is_open()) disk_error("write", path_, errno);
    if (::ftruncate(file_.get(), static_cast<off_t>(end_)) != 0)
        disk_error("write", path_, errno);
    if (end_ == 0) {
        append(preamble());
        sync();
        sync_folder_of(path_);
    }
}

void Journal::cut_back() const
{
    // if this fails too, the rest is a torn end: the next opening cuts it off
    if (::ftruncate(file_.get(), static_cast<off_t>(end_)) != 0) return;
}

void Journal::append(std::string_view batch)
{
    if (const int error = write_at(file_.get(), batch.data(), batch.size(), end_); error != 0) {
        cut_back();
        disk_error("write", path_, error);
    }
    const bool was_unsynced = unsynced_;
    unsynced_ = true;
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - synced_at_;
    if (since.count() >= sync_seconds_) {
        try {
            sync();
        } catch (...) {
            unsynced_ = was_unsynced;
            cut_back();
            throw;
        }
    }
    end_ += batch.size();
}

void Journal::sync()
{
    if (!unsynced_) return;
    // not fdatasync alone for safety against a kill: that needs none. This is for power cuts.
    if (::fdatasync(file_.get()) != 0) disk_error("write", path_, errno);
    unsynced_ = false;
    synced_at_ = std::chrono::steady_clock::now();
}

} // namespace app
