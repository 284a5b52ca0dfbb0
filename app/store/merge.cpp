#include "app/store/merge.hpp"

#include "app/store/file_lock.hpp"
#include "app/store/store_disk.hpp"
#include "app/store/store_parts.hpp"
#include "app/store/store_reader.hpp"
#include "app/store/wall_file.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <utility>

namespace app {

namespace {

namespace fs = std::filesystem;

/// Every shard keeps its files open.
void allow_open_files(std::size_t n)
{
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= n) return;
    limit.rlim_cur = std::min<rlim_t>(n, limit.rlim_max);
    ::setrlimit(RLIMIT_NOFILE, &limit); // too few: the opening of a shard says so
}

std::string list_of(const std::vector<WallKey>& walls)
{
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, walls.size()); ++k)
        text += "  " + wall_name(walls[k]) + "\n";
    if (walls.size() > most) text += "  and " + std::to_string(walls.size() - most) + " more\n";
    return text;
}

/// The head of a shard as that of the whole: what must be equal among shards.
StoreHead whole(StoreHead head)
{
    head.shard = 0;
    head.shards = 1;
    head.sessions.clear();
    return head;
}

/// Everything that must be equal among shards, line by line.
std::string whole_text(const StoreHead& head)
{
    std::string text = study_text(whole(head)) + "design grown through";
    for (const std::uint32_t size : head.design_sizes) text += " " + std::to_string(size);
    for (const StoreLevel& level : head.levels)
        text += "\nlevel of " + std::to_string(level.vertical_stress) + " Pa, " +
                std::to_string(level.samples) + " samples";
    text +=
        head.single_precision_curves ? "\nsingle precision yes\n" : "\nsingle precision no\n";
    return text + head.configuration;
}

void check_equal(const fs::path& first_path, const StoreHead& first, const fs::path& path,
                 const StoreHead& other)
{
    const std::string one = solver_revision(first.identity),
                      two = solver_revision(other.identity);
    if (one != two)
        throw StoreError("'" + path.string() + "' is of " + revision_words(two) + ", '" +
                         first_path.string() + "' of " + revision_words(one) +
                         ": each gives other numbers for the same walls. Nothing was written. "
                         "Merge shards that one revision has run.");
    const std::string why = text_difference(whole_text(first), whole_text(other));
    if (!why.empty() || !(whole(first) == whole(other)))
        throw StoreError("'" + path.string() + "' is not of the study of '" +
                         first_path.string() + "' (-: there, +: here):\n" + why +
                         "Nothing was written. Merge shards of one study only.");
}

/// Adds the walls of a shard to those of the shards before it. @param in which shard has a wall
void add_walls(const fs::path& shard, const StoreReader& reader,
               std::map<WallKey, fs::path>& in)
{
    for (const WallStatus& wall : reader.statuses())
        if (const auto [there, is_new] = in.emplace(wall.key, shard); !is_new)
            throw StoreError(wall_name(wall.key) + " is in '" + there->second.string() +
                             "' and in '" + shard.string() +
                             "'. Nothing was written. Name each shard once; shards of two "
                             "versions of the program may divide the walls differently.");
}

std::vector<StoreReader> open_shards(const std::vector<fs::path>& paths)
{
    if (paths.empty()) throw std::invalid_argument("merge: at least one shard is needed");
    allow_open_files(8 * paths.size() + 128);
    std::vector<StoreReader> shards;
    std::map<WallKey, fs::path> in;
    for (const fs::path& path : paths) {
        shards.emplace_back(path);
        check_equal(paths.front(), shards.front().head(), path, shards.back().head());
        add_walls(path, shards.back(), in);
    }
    return shards;
}

StoreHead merged_head(const std::vector<StoreReader>& shards)
{
    StoreHead head = whole(shards.front().head());
    for (const StoreReader& shard : shards)
        head.sessions.insert(head.sessions.end(), shard.head().sessions.begin(),
                             shard.head().sessions.end());
    return head;
}

} // namespace

void merge(const fs::path& out, const std::vector<fs::path>& paths, bool partial)
{
    std::vector<StoreReader> shards = open_shards(paths);
    const FileLock lock(lock_of(out));
    std::error_code error;
    if (open_to_read(out).is_open() || fs::exists(parts_of(out), error))
        throw StoreError("'" + out.string() +
                         "' (or the folder with its parts) is there already. Nothing was "
                         "written. Remove it or name another file.");
    const StoreHead head = merged_head(shards);
    StoreReader all(std::move(shards));
    const std::vector<WallKey> missing = missing_walls(head, all.statuses());
    if (!missing.empty() && !partial)
        throw StoreError(
            std::to_string(missing.size()) +
            " walls are in no shard. Nothing was written. Finish the shards, or ask "
            "for a partial merge:\n" +
            list_of(missing));
    write_wall_file(out, head, all.walls());
}

} // namespace app
