#include "app/store/store.hpp"

#include "app/store/file_lock.hpp"
#include "app/store/journal.hpp"
#include "app/store/store_head_codec.hpp"
#include "app/store/store_row_codec.hpp"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <stdexcept>
#include <string>
#include <unistd.h>

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr std::int32_t kAbsent = std::numeric_limits<std::int32_t>::min();

/// Status of every wall by level and sample, as long as the last that is there.
class StatusTable {
  public:
    std::int32_t get(WallKey key) const
    {
        if (key.level >= levels_.size() || key.sample >= levels_[key.level].size())
            return kAbsent;
        return levels_[key.level][key.sample];
    }
    void set(WallKey key, std::int32_t status)
    {
        if (levels_.size() <= key.level) levels_.resize(key.level + 1);
        std::vector<std::int32_t>& level = levels_[key.level];
        if (level.size() <= key.sample) level.resize(key.sample + 1, kAbsent);
        if (level[key.sample] == kAbsent) ++size_;
        level[key.sample] = status;
    }
    std::size_t size() const { return size_; }
    std::vector<WallStatus> list() const
    {
        std::vector<WallStatus> all;
        all.reserve(size_);
        for (std::uint32_t level = 0; level < levels_.size(); ++level)
            for (std::uint32_t sample = 0; sample < levels_[level].size(); ++sample)
                if (const std::int32_t status = levels_[level][sample]; status != kAbsent)
                    all.push_back({{level, sample}, status});
        return all;
    }

  private:
    std::vector<std::vector<std::int32_t>> levels_;
    std::size_t size_ = 0;
};

/// All but the sessions: these alone are no reason to write anything.
bool same_but_sessions(StoreHead a, const StoreHead& b)
{
    a.sessions = b.sessions;
    return encode_head(a) == encode_head(b);
}

bool is_there(const fs::path& path) { return open_to_read(path).is_open(); }

std::uint64_t length_of(const fs::path& path)
{
    const OpenFile file = open_to_read(path);
    return file.is_open() ? file_length(file, path) : 0;
}

} // namespace

struct Store::Impl {
    fs::path path;
    StoreOptions options;
    FileLock lock;
    StoreHead head;
    JournalState replayed;
    StatusTable walls;
    std::optional<Journal> journal;
    std::uint64_t journal_end = 0; ///< where an old journal is gone on with [bytes]
    std::uint64_t file_bytes = 0;
    std::uint64_t compact_again_at = 0; ///< after a failure [bytes of journal]
    bool head_pending = true;           ///< the journal has not this head yet

    Impl(fs::path file, const StoreHead& wanted, const StoreOptions& with)
        : path(std::move(file)), options(with), lock(lock_of(path))
    {
        check_head(wanted);
        if (is_there(path))
            go_on(wanted);
        else
            create(wanted);
        file_bytes = length_of(path);
    }

    void create(const StoreHead& wanted)
    {
        if (is_there(journal_of(path)))
            throw StoreError("'" + journal_of(path).string() + "' is there without its '" +
                             path.string() +
                             "'; bring that back, or remove the journal: its walls are run "
                             "again");
        StoreHead none = wanted;
        none.sessions.clear();
        head = continued_head(path.string(), none, wanted);
        replace_study_file(path, head, {});
    }

    void go_on(const StoreHead& wanted)
    {
        const StoreReader stored(path);
        head = continued_head(path.string(), stored.head(), wanted);
        replayed = stored.journal();
        journal_end = replayed.bytes;
        for (const WallStatus& wall : stored.statuses()) walls.set(wall.key, wall.status);
        ::unlink(part_of(path).c_str()); // of a killed compaction
        const bool has_journal = is_there(journal_of(path));
        if (!same_but_sessions(head, stored.head()))
            start_journal();
        else if (has_journal) // cuts a torn end off
            journal.emplace(journal_of(path), journal_end, options.sync_seconds);
    }

    /// The journal with this head in it.
    Journal& start_journal()
    {
        if (!journal) journal.emplace(journal_of(path), journal_end, options.sync_seconds);
        if (head_pending) {
            std::string record;
            put_record(record, RecordKind::head, encode_head(head));
            journal->append(record);
            head_pending = false;
        }
        return *journal;
    }

    void check_rows(std::span<const WallRow> rows) const
    {
        std::vector<WallKey> keys;
        for (const WallRow& row : rows) {
            check_row(head, row);
            if (walls.get(row.key) == kWallOk)
                throw std::invalid_argument(wall_name(row.key) + ": is stored already");
            keys.push_back(row.key);
        }
        std::ranges::sort(keys);
        if (const auto twice = std::ranges::adjacent_find(keys); twice != keys.end())
            throw std::invalid_argument(wall_name(*twice) + ": is twice in one batch");
    }

    void append(std::span<const WallRow> rows)
    {
        check_rows(rows);
        if (rows.empty()) return;
        std::string batch, bytes;
        for (const WallRow& row : rows) {
            bytes.clear();
            encode_row(head, row, bytes);
            put_record(batch, RecordKind::wall, bytes);
        }
        start_journal().append(batch);
        for (const WallRow& row : rows) walls.set(row.key, row.status);
    }

    /// Without room for a new FILE.h5 the journal goes on growing; compact() says so.
    void compact_if_long()
    {
        const std::uint64_t limit =
            std::max({options.journal_bytes, file_bytes, compact_again_at});
        if (!journal || journal->length() <= limit) return;
        try {
            compact();
        } catch (const StoreError&) {
            compact_again_at = 2 * journal->length();
        }
    }

    void compact()
    {
        if (!journal) return;
        if (head_pending) start_journal(); // this process took part
        StoreReader stored(path);
        const RowSource source{stored.size(), [&](std::size_t i) { return stored.row(i); }};
        replace_study_file(path, head, source, options.reached);
        if (::unlink(journal_of(path).c_str()) != 0)
            disk_error("remove", journal_of(path), errno);
        journal.reset();
        journal_end = compact_again_at = 0;
        head_pending = true;
        file_bytes = length_of(path);
        sync_folder_of(path);
        if (options.reached) options.reached(StoreStage::journal_removed);
    }
};

Store::Store(fs::path file, const StoreHead& wanted, const StoreOptions& options)
    : impl_(std::make_unique<Impl>(std::move(file), wanted, options))
{
}

Store::~Store()
{
    if (!impl_) return; // moved from
    try {
        sync();
    } catch (const std::exception&) {
        // nothing a destructor could do; who must know calls sync() before
    }
}

Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

const StoreHead& Store::head() const { return impl_->head; }
const JournalState& Store::replayed() const { return impl_->replayed; }
std::size_t Store::size() const { return impl_->walls.size(); }
std::vector<WallStatus> Store::statuses() const { return impl_->walls.list(); }

std::optional<std::int32_t> Store::status(WallKey key) const
{
    const std::int32_t status = impl_->walls.get(key);
    if (status == kAbsent) return {};
    return status;
}

void Store::append(std::span<const WallRow> rows)
{
    impl_->append(rows);
    impl_->compact_if_long();
}

void Store::sync()
{
    if (impl_->journal) impl_->journal->sync();
}

void Store::compact() { impl_->compact(); }

} // namespace app
