#include "app/store/store_reader.hpp"

#include "app/store/journal.hpp"
#include "app/store/store_columns.hpp"
#include "app/store/store_file.hpp"
#include "app/store/store_head_codec.hpp"
#include "app/store/store_row_codec.hpp"
#include "app/store/store_seal.hpp"

#include <algorithm>
#include <array>

namespace app {

namespace {

namespace fs = std::filesystem;
using hdf5::ColumnReader;
using hdf5::Shape;

/// Where a wall is.
struct Entry {
    RowSummary row;
    std::uint64_t where = 0; ///< row of FILE.h5, or offset in the journal
    std::uint64_t bytes = 0; ///< in the journal; 0: in FILE.h5
};

[[noreturn]] void damaged(const fs::path& path, const std::string& what)
{
    throw StoreError("'" + path.string() + "' is damaged: " + what);
}

StoreHead stored_head(const hdf5::File& file)
{
    const std::uint64_t n = hdf5::rows_of(file, "/head");
    std::string bytes(static_cast<std::size_t>(n), '\0');
    ColumnReader(file, "/head", Shape{H5T_STD_U8LE, H5T_NATIVE_UINT8, n})
        .read(0, n, bytes.data());
    return decode_head(bytes, file.path.string());
}

StoreSize stored_size(const hdf5::File& file)
{
    return {hdf5::rows_of(file, "/walls/level"), hdf5::rows_of(file, "/curves/displacement"),
            hdf5::element_bytes(file, "/walls/reason")};
}

} // namespace

struct StoreReader::Impl {
    fs::path path;
    OpenFile journal_file;
    hdf5::File file;
    StoreHead head;
    JournalState journal;
    StoreSize stored; ///< of FILE.h5
    StoreSize size;
    hdf5::Handle reason_type;
    std::vector<Entry> entries;
    std::vector<WallStatus> statuses;
    std::unique_ptr<hdf5::StudyColumns<ColumnReader>> columns;

    explicit Impl(const fs::path& from);
    void open_columns();
    void index_file();
    void index_journal();
    void merge_entries(std::size_t of_file);
    WallRow row_of_file(const Entry& entry);
    WallRow row_of_journal(const Entry& entry) const;
};

StoreReader::Impl::Impl(const fs::path& from) : path(from)
{
    // the journal first: a compaction in between then only makes walls appear in both
    journal_file = open_to_read(journal_of(path));
    OpenFile disk = open_to_read(path);
    if (!disk.is_open())
        throw StoreError(
            "cannot open '" + path.string() + "': no such file" +
            (journal_file.is_open() ? "; bring it back, its journal is there" : ""));
    check_seal(disk, path);
    file = hdf5::open_file(path, std::move(disk));
    head = stored_head(file);
    open_columns();
    index_file();
    const std::size_t of_file = entries.size();
    index_journal();
    merge_entries(of_file);
}

void StoreReader::Impl::open_columns()
{
    stored = stored_size(file);
    reason_type = hdf5::text_type(static_cast<std::size_t>(stored.reason_bytes));
    columns = std::make_unique<hdf5::StudyColumns<ColumnReader>>(
        hdf5::study_columns<ColumnReader>(head, stored, reason_type.get(),
                                          [this](const std::string& name, const Shape& shape) {
                                              return ColumnReader(file, name, shape);
                                          }));
}

void StoreReader::Impl::index_file()
{
    entries.reserve(static_cast<std::size_t>(stored.walls));
    std::string reason(static_cast<std::size_t>(stored.reason_bytes), '\0');
    std::uint64_t begin = 0, end = 0;
    columns->offset.read(0, 1, &begin);
    if (begin != 0) damaged(path, "the first curve does not begin at 0");
    for (std::uint64_t i = 0; i < stored.walls; ++i, begin = end) {
        Entry entry;
        columns->level.read(i, 1, &entry.row.key.level);
        columns->sample.read(i, 1, &entry.row.key.sample);
        columns->status.read(i, 1, &entry.row.status);
        columns->reason.read(i, 1, reason.data());
        columns->offset.read(i + 1, 1, &end);
        if (end < begin || end > stored.points) damaged(path, "curves overlap");
        if (!entries.empty() && entries.back().row.key >= entry.row.key)
            damaged(path, "walls are out of order");
        entry.row.points = end - begin;
        entry.row.reason_bytes =
            static_cast<std::uint32_t>(std::min(reason.find('\0'), reason.size()));
        entry.where = i;
        entries.push_back(entry);
    }
}

void StoreReader::Impl::index_journal()
{
    if (!journal_file.is_open()) return;
    const fs::path name = journal_of(path);
    bool with_head = false;
    const auto visit = [&](RecordKind kind, std::uint64_t offset, std::string_view bytes) {
        if (kind == RecordKind::head) {
            StoreHead next = decode_head(bytes, name.string());
            if (const std::string why = study_difference(head, next); !why.empty())
                throw StoreError("'" + name.string() +
                                 "' is not of the study beside it, which " + why +
                                 "\nMove it away, or bring its file back.");
            head = std::move(next);
            with_head = true;
        } else if (kind == RecordKind::wall && with_head) {
            entries.push_back(
                {decode_summary(head, bytes, name.string()), offset, bytes.size()});
        } else {
            damaged(name, with_head ? "a record of unknown kind" : "it has no head");
        }
    };
    journal = scan_journal(journal_file, name, visit);
}

/// Sorts by key; of several with one key the last in the journal counts.
void StoreReader::Impl::merge_entries(std::size_t of_file)
{
    const auto by_key = [](const Entry& a, const Entry& b) { return a.row.key < b.row.key; };
    const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(of_file);
    std::stable_sort(middle, entries.end(), by_key);
    std::inplace_merge(entries.begin(), middle, entries.end(), by_key);
    std::size_t kept = 0;
    for (const Entry& entry : entries) {
        if (kept > 0 && entries[kept - 1].row.key == entry.row.key) --kept;
        entries[kept++] = entry;
    }
    entries.resize(kept);
    statuses.reserve(kept);
    for (const Entry& entry : entries) {
        const auto [level, sample] = entry.row.key;
        if (level >= head.levels.size() || sample >= head.levels[level].samples)
            damaged(path, "a wall is outside the study");
        statuses.push_back({entry.row.key, entry.row.status});
        size.points += entry.row.points;
        size.reason_bytes = std::max<std::uint64_t>(size.reason_bytes, entry.row.reason_bytes);
    }
    size.walls = kept;
}

WallRow StoreReader::Impl::row_of_file(const Entry& entry)
{
    const std::uint64_t i = entry.where;
    WallRow row;
    row.key = entry.row.key;
    row.status = entry.row.status;
    row.reason.resize(static_cast<std::size_t>(stored.reason_bytes));
    columns->reason.read(i, 1, row.reason.data());
    row.reason.resize(entry.row.reason_bytes);
    row.inputs.resize(head.inputs.size());
    columns->inputs.read(i, 1, row.inputs.data());
    const auto each = [i](std::vector<ColumnReader>& from, auto& values) {
        values.resize(from.size());
        for (std::size_t k = 0; k < from.size(); ++k) from[k].read(i, 1, &values[k]);
    };
    each(columns->responses, row.responses);
    each(columns->counts, row.counts);
    each(columns->cost, row.cost);
    std::uint64_t begin = 0;
    columns->offset.read(i, 1, &begin);
    row.curve.further.resize(head.curve_columns.size());
    for (std::size_t k = 0; k < columns->curve.size(); ++k) {
        std::vector<double>& values = k == 0   ? row.curve.displacement
                                      : k == 1 ? row.curve.force
                                               : row.curve.further[k - 2];
        values.resize(static_cast<std::size_t>(entry.row.points));
        columns->curve[k].read(begin, entry.row.points, values.data());
    }
    return row;
}

WallRow StoreReader::Impl::row_of_journal(const Entry& entry) const
{
    std::string bytes(static_cast<std::size_t>(entry.bytes), '\0');
    const fs::path name = journal_of(path);
    if (read_at(journal_file, name, bytes.data(), bytes.size(), entry.where) != bytes.size())
        damaged(name, "it has become shorter");
    return decode_row(head, bytes, name.string());
}

StoreReader::StoreReader(const fs::path& file) : impl_(std::make_unique<Impl>(file)) {}
StoreReader::~StoreReader() = default;
StoreReader::StoreReader(StoreReader&&) noexcept = default;
StoreReader& StoreReader::operator=(StoreReader&&) noexcept = default;

const StoreHead& StoreReader::head() const { return impl_->head; }
const JournalState& StoreReader::journal() const { return impl_->journal; }
const StoreSize& StoreReader::size() const { return impl_->size; }
const std::vector<WallStatus>& StoreReader::statuses() const { return impl_->statuses; }

WallRow StoreReader::row(std::size_t i)
{
    const Entry& entry = impl_->entries.at(i);
    return entry.bytes > 0 ? impl_->row_of_journal(entry) : impl_->row_of_file(entry);
}

std::optional<WallRow> StoreReader::row(WallKey key)
{
    const auto found = std::ranges::lower_bound(impl_->statuses, key, {}, &WallStatus::key);
    if (found == impl_->statuses.end() || found->key != key) return {};
    return row(static_cast<std::size_t>(found - impl_->statuses.begin()));
}

void StoreReader::for_each_row(const std::function<void(const WallRow&)>& visit)
{
    for (std::size_t i = 0; i < impl_->entries.size(); ++i) visit(row(i));
}

StoreHead read_head(const fs::path& file) { return StoreReader(file).head(); }

std::vector<WallKey> missing_walls(const StoreHead& head, const std::vector<WallStatus>& there)
{
    std::vector<WallKey> missing;
    auto next = there.begin();
    for (std::uint32_t level = 0; level < head.levels.size(); ++level)
        for (std::uint32_t sample = 0; sample < head.levels[level].samples; ++sample) {
            while (next != there.end() && next->key < WallKey{level, sample}) ++next;
            if (next == there.end() || next->key != WallKey{level, sample})
                missing.push_back({level, sample});
        }
    return missing;
}

} // namespace app
