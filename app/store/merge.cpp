#include "app/store/merge.hpp"

#include "app/store/file_lock.hpp"
#include "app/store/store_file.hpp"
#include "app/store/store_head_codec.hpp"
#include "app/store/store_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <sys/resource.h>

namespace app {

namespace {

namespace fs = std::filesystem;

/// Wall `row` of shard `shard`.
struct Place {
    WallKey key;
    std::uint32_t shard = 0;
    std::uint32_t row = 0;
};

/// Every shard keeps its file and its journal open.
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

/// Without what moves no result.
std::string comparable(const StoreHead& head)
{
    StoreHead same = whole(head);
    same.compression = 0;
    return encode_head(same);
}

std::string sizes_text(const StoreHead& head)
{
    std::string text = "design grown through";
    for (const std::uint32_t size : head.design_sizes) text += " " + std::to_string(size);
    for (const StoreLevel& level : head.levels)
        text += "\nlevel of " + std::to_string(level.vertical_stress) + " Pa, " +
                std::to_string(level.samples) + " samples";
    return text + "\nsingle precision " + (head.single_precision_curves ? "yes\n" : "no\n");
}

void check_equal(const fs::path& first_path, const StoreHead& first, const fs::path& path,
                 const StoreHead& other)
{
    std::string why = study_difference(whole(first), whole(other));
    if (why.empty() && first.configuration != other.configuration)
        why = "has another configuration (- there, + here):\n" +
              text_difference(first.configuration, other.configuration);
    if (why.empty() && comparable(first) != comparable(other))
        why = "was run with other sizes (- there, + here):\n" +
              text_difference(sizes_text(first), sizes_text(other));
    if (!why.empty() && why.back() != '\n') why += '\n';
    if (!why.empty())
        throw StoreError("'" + path.string() + "' is not of the study of '" +
                         first_path.string() + "', which " + why +
                         "Nothing was written. Merge shards of one study only.");
}

/// Walls of all shards in the order of their keys, then of the shards.
std::vector<Place> places_of(const std::vector<StoreReader>& shards)
{
    std::vector<Place> places;
    for (std::uint32_t s = 0; s < shards.size(); ++s) {
        const std::vector<WallStatus>& walls = shards[s].statuses();
        for (std::uint32_t i = 0; i < walls.size(); ++i) places.push_back({walls[i].key, s, i});
    }
    std::ranges::stable_sort(places, {}, &Place::key);
    return places;
}

struct Dropped {
    std::size_t walls = 0;
    std::uint64_t points = 0; ///< of their curves
};

/// Keeps the first of walls that several shards have, if that is allowed.
Dropped drop_overlaps(const std::vector<fs::path>& paths, std::vector<StoreReader>& shards,
                      std::vector<Place>& places, bool allowed)
{
    Dropped dropped;
    std::size_t kept = 0;
    for (const Place& place : places) {
        if (kept == 0 || places[kept - 1].key != place.key) {
            places[kept++] = place;
            continue;
        }
        const Place& first = places[kept - 1];
        const WallRow again = shards[place.shard].row(place.row);
        const bool same = allowed && same_results(shards[first.shard].row(first.row), again);
        if (!same)
            throw StoreError(wall_name(place.key) + " is in '" + paths[first.shard].string() +
                             "' and in '" + paths[place.shard].string() + "'" +
                             (allowed ? " with other results" : "") +
                             ". Nothing was written. Name each shard once.");
        ++dropped.walls;
        dropped.points += again.curve.displacement.size();
    }
    places.resize(kept);
    return dropped;
}

StoreHead merged_head(const std::vector<StoreReader>& shards)
{
    StoreHead head = whole(shards.front().head());
    for (const StoreReader& shard : shards)
        head.sessions.insert(head.sessions.end(), shard.head().sessions.begin(),
                             shard.head().sessions.end());
    return head;
}

StoreSize size_of(const std::vector<StoreReader>& shards, const Dropped& dropped)
{
    StoreSize size;
    for (const StoreReader& shard : shards) {
        size.walls += shard.size().walls;
        size.points += shard.size().points;
        size.reason_bytes = std::max(size.reason_bytes, shard.size().reason_bytes);
    }
    size.walls -= dropped.walls;
    size.points -= dropped.points;
    return size;
}

std::vector<StoreReader> open_shards(const std::vector<fs::path>& paths)
{
    if (paths.empty()) throw std::invalid_argument("merge: at least one shard is needed");
    allow_open_files(2 * paths.size() + 32);
    std::vector<StoreReader> shards;
    for (const fs::path& path : paths) {
        shards.emplace_back(path);
        check_equal(paths.front(), shards.front().head(), path, shards.back().head());
    }
    return shards;
}

MergeReport report_of(const StoreHead& head, const std::vector<StoreReader>& shards,
                      const std::vector<Place>& places, bool partial)
{
    MergeReport report;
    std::vector<WallStatus> there;
    for (const Place& place : places) {
        there.push_back(shards[place.shard].statuses()[place.row]);
        if (there.back().status != kWallOk) ++report.failed;
    }
    report.walls = there.size();
    report.missing = missing_walls(head, there);
    if (!report.missing.empty() && !partial)
        throw StoreError(
            std::to_string(report.missing.size()) +
            " walls are in no shard. Nothing was written. Finish the shards, or ask "
            "for a partial merge:\n" +
            list_of(report.missing));
    return report;
}

} // namespace

MergeReport merge(const fs::path& out, const std::vector<fs::path>& paths,
                  const MergeOptions& options)
{
    std::vector<StoreReader> shards = open_shards(paths);
    const FileLock lock(lock_of(out));
    if (open_to_read(out).is_open() || open_to_read(journal_of(out)).is_open())
        throw StoreError("'" + out.string() +
                         "' (or its journal) is there already. Nothing was "
                         "written. Remove it or name another file.");
    std::vector<Place> places = places_of(shards);
    const Dropped dropped = drop_overlaps(paths, shards, places, options.identical_overlap);
    const StoreHead head = merged_head(shards);
    MergeReport report = report_of(head, shards, places, options.partial);
    report.overlapping = dropped.walls;
    replace_study_file(out, head, {size_of(shards, dropped), [&](std::size_t i) {
                                       return shards[places[i].shard].row(places[i].row);
                                   }});
    return report;
}

} // namespace app
