#include "app/store/store.hpp"

#include "app/store/continued_head.hpp"
#include "app/store/hdf5/file_lock.hpp"
#include "app/store/hdf5/store_disk.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

namespace app {

namespace {

namespace fs = std::filesystem;

/// Compares everything but sessions; a new session alone does not rewrite the file.
bool same_but_sessions(StoreHead a, const StoreHead& b)
{
    a.sessions = b.sessions;
    return a == b;
}

} // namespace

Store::Store(const fs::path& file, const StoreHead& wanted, const StoreOptions& options)
    : path_(linked_file(file)), options_(options), lock_(lock_of(path_)),
      parts_(part_numbers(path_)), merge_at_(options.most_parts)
{
    check_head(wanted);
    if (open_to_read(path_).is_open())
        go_on(wanted);
    else
        create(wanted);
}

void Store::create(const StoreHead& wanted)
{
    if (!parts_.empty())
        throw StoreError(
            "'" + parts_of(path_).string() + "' is there without its '" + path_.string() +
            "'; restore that file, or remove the folder: its walls will be run again");
    StoreHead none = wanted;
    none.sessions.clear();
    head_ = continued_head(path_.string(), none, wanted);
    write_wall_file(path_, head_, {});
}

void Store::go_on(const StoreHead& wanted)
{
    const StoreReader stored(path_);
    head_ = continued_head(path_.string(), stored.head(), wanted);
    for (const WallStatus& wall : stored.statuses()) walls_[wall.key] = wall.status;
    remove_parts(path_, {}); // what a killed process left there
    if (!same_but_sessions(head_, stored.head())) add_part({});
}

std::optional<std::int32_t> Store::status(WallKey key) const
{
    const auto found = walls_.find(key);
    if (found == walls_.end()) return {};
    return found->second;
}

void Store::add_part(const std::vector<const WallRow*>& rows)
{
    RowSource source{rows.size(), 0, [&](std::size_t i) { return *rows[i]; }};
    for (const WallRow* row : rows) source.points += row->curve.displacement.size();
    const std::uint32_t number = parts_.empty() ? 1 : parts_.back() + 1;
    // only with the first: a folder that is gone later took walls with it
    if (parts_.empty()) make_parts_folder(path_);
    check_parts_folder(path_); // others may have put a link there meanwhile
    write_wall_file(part_of(path_, number), head_, source);
    parts_.push_back(number);
}

void Store::append(std::span<const WallRow> rows)
{
    if (rows.empty()) return;
    std::vector<const WallRow*> sorted;
    for (const WallRow& row : rows) {
        check_row(head_, row);
        if (status(row.key) == kWallOk)
            throw std::invalid_argument(wall_name(row.key) + ": is stored already");
        sorted.push_back(&row);
    }
    const auto key = [](const WallRow* row) { return row->key; };
    std::ranges::sort(sorted, {}, key);
    if (const auto twice = std::ranges::adjacent_find(sorted, {}, key); twice != sorted.end())
        throw std::invalid_argument(wall_name((*twice)->key) + ": is twice in one batch");
    add_part(sorted);
    for (const WallRow& row : rows) walls_[row.key] = row.status;
    if (parts_.size() >= merge_at_) merge_parts();
}

/// All parts into one, or into FILE.h5 once they are a quarter of it: a wall is then rewritten
/// only a few times however long the study runs.
void Store::merge_parts()
{
    try {
        if (4 * (walls_.size() - compacted_) >= compacted_)
            compact();
        else
            fold();
        merge_at_ = options_.most_parts;
    } catch (const StoreError&) {
        merge_at_ = 2 * parts_.size(); // no room: compact() says so
    }
}

/// Takes the name of the last: whatever is lost or left by a kill, no wall is.
void Store::fold()
{
    std::vector<StoreReader> readers;
    for (const std::uint32_t number : parts_) readers.emplace_back(part_of(path_, number));
    StoreReader stored(std::move(readers));
    write_wall_file(part_of(path_, parts_.back()), head_, stored.walls());
    const std::uint32_t last = parts_.back();
    parts_.pop_back();
    remove_parts(path_, std::exchange(parts_, {last}));
}

void Store::compact()
{
    if (parts_.empty()) return;
    StoreReader stored(path_);
    if (stored.statuses().size() < walls_.size())
        throw StoreError("walls are missing in '" + parts_of(path_).string() +
                         "', which was changed while the study ran; run the same command "
                         "again: they will be run again");
    write_wall_file(path_, head_, stored.walls(), options_.reached);
    remove_parts(path_, std::exchange(parts_, {}));
    sync_folder_of(path_);
    compacted_ = walls_.size();
    if (options_.reached) options_.reached(StoreStage::parts_removed);
}

} // namespace app
