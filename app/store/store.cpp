#include "app/store/store.hpp"

#include "app/store/file_lock.hpp"
#include "app/store/store_disk.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace app {

namespace {

namespace fs = std::filesystem;

/// All but the sessions: these alone are no reason to write anything.
bool same_but_sessions(StoreHead a, const StoreHead& b)
{
    a.sessions = b.sessions;
    return a == b;
}

} // namespace

struct Store::Impl {
    fs::path path;
    StoreOptions options;
    FileLock lock;
    StoreHead head;
    std::map<WallKey, std::int32_t> walls; ///< with their statuses
    std::vector<std::uint32_t> parts;      ///< numbers, increasing
    std::size_t merge_at;                  ///< number of parts
    std::size_t compacted = 0;             ///< walls in FILE.h5 since this process wrote it

    Impl(const fs::path& file, const StoreHead& wanted, const StoreOptions& with)
        : path(linked_file(file)), options(with), lock(lock_of(path)),
          parts(part_numbers(path)), merge_at(with.most_parts)
    {
        check_head(wanted);
        if (open_to_read(path).is_open())
            go_on(wanted);
        else
            create(wanted);
    }

    void create(const StoreHead& wanted)
    {
        if (!parts.empty())
            throw StoreError(
                "'" + parts_of(path).string() + "' is there without its '" + path.string() +
                "'; bring that back, or remove the folder: its walls are run again");
        StoreHead none = wanted;
        none.sessions.clear();
        head = continued_head(path.string(), none, wanted);
        write_wall_file(path, head, {});
    }

    void go_on(const StoreHead& wanted)
    {
        const StoreReader stored(path);
        head = continued_head(path.string(), stored.head(), wanted);
        for (const WallStatus& wall : stored.statuses()) walls[wall.key] = wall.status;
        remove_parts(path, {}); // what a killed process left there
        if (!same_but_sessions(head, stored.head())) add_part({});
    }

    std::optional<std::int32_t> status(WallKey key) const
    {
        const auto found = walls.find(key);
        if (found == walls.end()) return {};
        return found->second;
    }

    void add_part(const std::vector<const WallRow*>& rows)
    {
        RowSource source{rows.size(), 0, [&](std::size_t i) { return *rows[i]; }};
        for (const WallRow* row : rows) source.points += row->curve.displacement.size();
        const std::uint32_t number = parts.empty() ? 1 : parts.back() + 1;
        // only with the first: a folder that is gone later took walls with it
        if (parts.empty()) make_parts_folder(path);
        write_wall_file(part_of(path, number), head, source);
        parts.push_back(number);
    }

    void append(std::span<const WallRow> rows)
    {
        if (rows.empty()) return;
        std::vector<const WallRow*> sorted;
        for (const WallRow& row : rows) {
            check_row(head, row);
            if (status(row.key) == kWallOk)
                throw std::invalid_argument(wall_name(row.key) + ": is stored already");
            sorted.push_back(&row);
        }
        const auto key = [](const WallRow* row) { return row->key; };
        std::ranges::sort(sorted, {}, key);
        if (const auto twice = std::ranges::adjacent_find(sorted, {}, key);
            twice != sorted.end())
            throw std::invalid_argument(wall_name((*twice)->key) + ": is twice in one batch");
        add_part(sorted);
        for (const WallRow& row : rows) walls[row.key] = row.status;
        if (parts.size() >= merge_at) merge_parts();
    }

    /// All parts into one, or into FILE.h5 once they are a quarter of it: a wall is then rewritten
    /// only a few times however long the study runs.
    void merge_parts()
    {
        try {
            if (4 * (walls.size() - compacted) >= compacted)
                compact();
            else
                fold();
            merge_at = options.most_parts;
        } catch (const StoreError&) {
            merge_at = 2 * parts.size(); // no room: compact() says so
        }
    }

    /// Takes the name of the last: whatever is lost or left by a kill, no wall is.
    void fold()
    {
        std::vector<StoreReader> readers;
        for (const std::uint32_t number : parts) readers.emplace_back(part_of(path, number));
        StoreReader stored(std::move(readers));
        write_wall_file(part_of(path, parts.back()), head, stored.walls());
        const std::uint32_t last = parts.back();
        parts.pop_back();
        remove_parts(path, std::exchange(parts, {last}));
    }

    void compact()
    {
        if (parts.empty()) return;
        StoreReader stored(path);
        if (stored.statuses().size() < walls.size())
            throw StoreError("walls are missing in '" + parts_of(path).string() +
                             "', which was changed while the study ran; run the same command "
                             "again: they are run again");
        write_wall_file(path, head, stored.walls(), options.reached);
        remove_parts(path, std::exchange(parts, {}));
        sync_folder_of(path);
        compacted = walls.size();
        if (options.reached) options.reached(StoreStage::parts_removed);
    }
};

Store::Store(fs::path file, const StoreHead& wanted, const StoreOptions& options)
    : impl_(std::make_unique<Impl>(file, wanted, options))
{
}

Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

const StoreHead& Store::head() const { return impl_->head; }
std::size_t Store::size() const { return impl_->walls.size(); }
std::optional<std::int32_t> Store::status(WallKey key) const { return impl_->status(key); }
void Store::append(std::span<const WallRow> rows) { impl_->append(rows); }
void Store::compact() { impl_->compact(); }

} // namespace app
