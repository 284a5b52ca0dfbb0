#include "app/store/merge.hpp"

#include "app/store/continued_head.hpp"
#include "app/store/hdf5/file_lock.hpp"
#include "app/store/hdf5/store_disk.hpp"
#include "app/store/record_keys.hpp"
#include "app/store/store_parts.hpp"
#include "app/store/store_reader.hpp"
#include "app/store/wall_file.hpp"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
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

constexpr std::size_t kMostListed = 20;

/// "  and 12 more" of a list of `all`.
std::string more_text(std::size_t all)
{
    if (all <= kMostListed) return "";
    return "  and " + std::to_string(all - kMostListed) + " more\n";
}

std::string list_of(const std::vector<WallKey>& walls)
{
    std::string text;
    for (std::size_t k = 0; k < std::min(kMostListed, walls.size()); ++k)
        text += "  " + wall_name(walls[k]) + "\n";
    return text + more_text(walls.size());
}

/// The head of a shard as that of the whole: what must be equal among shards.
StoreHead whole(StoreHead head)
{
    head.shard = 0;
    head.shards = 1;
    head.sessions.clear();
    return head;
}

/// All digits that a stress in pascals has.
std::string megapascals(double stress)
{
    std::ostringstream text;
    text << std::setprecision(15) << 1e-6 * stress << " MPa";
    return text.str();
}

/// All that must be equal among shards beside the study, line by line.
std::string plan_text(const StoreHead& head)
{
    std::string text = "design grown through";
    for (const std::uint32_t size : head.design_sizes) text += " " + std::to_string(size);
    for (const StoreLevel& level : head.levels)
        text += "\nlevel of " + megapascals(level.vertical_stress) + ", " +
                std::to_string(level.samples) + (level.samples == 1 ? " sample" : " samples") +
                (level.slower > 1 ? ", pushed again more slowly" : "") +
                (level.turned ? ", pushed the other way" : "");
    return text + (head.single_precision_curves ? "\nsingle precision yes\n"
                                                : "\nsingle precision no\n");
}

/// The first of these that differs: what follows from it in the others is not said again.
std::string shard_difference(const StoreHead& first, const StoreHead& other)
{
    const std::string texts[] = {study_difference(whole(first), whole(other)),
                                 text_difference(plan_text(first), plan_text(other)),
                                 text_difference(without_record_keys(first.configuration),
                                                 without_record_keys(other.configuration))};
    const auto* const why =
        std::ranges::find_if(texts, [](const std::string& text) { return !text.empty(); });
    return why == std::end(texts) ? "" : *why;
}

void check_equal(const fs::path& first_path, const StoreHead& first, const fs::path& path,
                 const StoreHead& other)
{
    const std::string one = solver_revision(first.identity),
                      two = solver_revision(other.identity);
    if (one != two)
        throw BadStoredStudy(
            "'" + path.string() + "' is of " + revision_words(two) + ", '" +
            first_path.string() + "' of " + revision_words(one) +
            ": each gives other numbers for the same walls. Nothing was written. "
            "Merge shards that one revision has run.");
    const std::string why = shard_difference(first, other);
    StoreHead here = whole(other);
    here.configuration = first.configuration;
    if (!why.empty() || !(whole(first) == here))
        throw BadStoredStudy("'" + path.string() + "' is not of the study of '" +
                             first_path.string() + "' (-: there, +: here):\n" + why +
                             "Nothing was written. Merge shards of one study only.");
}

/// "runs/t_3_of_3.h5", beside "runs/t_1_of_3.h5", which is shard 1; empty where that has
/// another name.
std::string shard_beside(const fs::path& path, std::uint32_t index, const StoreHead& head,
                         std::uint32_t wanted)
{
    const std::string of = "_of_" + std::to_string(head.shards);
    std::string name = path.filename().string();
    const std::size_t end = name.rfind(of);
    if (end == std::string::npos) return "";
    const std::size_t begin = name.find_last_not_of("0123456789", end - 1) + 1;
    const std::string digits = name.substr(begin, end - begin);
    if (digits.empty() || digits.size() > 9 || std::stoul(digits) != index + 1) return "";
    std::string number = std::to_string(wanted + 1);
    number.insert(0, digits.size() - std::min(digits.size(), number.size()), '0');
    name.replace(begin, digits.size(), number);
    return (path.parent_path() / name).string();
}

/// "  shard 3 of 3 is missing: runs/t_3_of_3.h5", a line for each; empty where some are no
/// shards, or all are there.
std::string missing_shards(const std::vector<fs::path>& paths,
                           const std::vector<StoreReader>& shards)
{
    const StoreHead& first = shards.front().head();
    std::set<std::uint32_t> there;
    for (const StoreReader& shard : shards) {
        if (shard.head().shards != first.shards) return "";
        there.insert(shard.head().shard);
    }
    const std::size_t missing = first.shards - there.size();
    std::string text;
    std::size_t listed = 0;
    for (std::uint32_t k = 0; listed < std::min(missing, kMostListed); ++k) {
        if (there.count(k) > 0) continue;
        ++listed;
        const std::string file = shard_beside(paths.front(), first.shard, first, k);
        text += "  shard " + std::to_string(k + 1) + " of " + std::to_string(first.shards) +
                " is missing" + (file.empty() ? "" : ": " + file) + "\n";
    }
    return text + more_text(missing);
}

/// Adds the walls of a shard to those of the shards before it. @param in which shard has a wall
void add_walls(const fs::path& shard, const StoreReader& reader,
               std::map<WallKey, fs::path>& in)
{
    for (const WallStatus& wall : reader.statuses())
        if (const auto [there, is_new] = in.emplace(wall.key, shard); !is_new)
            throw BadStoredStudy(wall_name(wall.key) + " is in '" + there->second.string() +
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

void merge(const fs::path& out, const std::vector<fs::path>& paths, bool partial,
           const WallCheck& check)
{
    std::vector<StoreReader> shards = open_shards(paths);
    const FileLock lock(lock_of(out));
    std::error_code error;
    if (open_to_read(out).is_open() || fs::exists(parts_of(out), error))
        throw BadStoredStudy("'" + out.string() +
                             "' (or the folder with its parts) is there already. Nothing was "
                             "written. Remove it or name another file.");
    const StoreHead head = merged_head(shards);
    const std::string absent = partial ? "" : missing_shards(paths, shards);
    if (!absent.empty())
        throw BadStoredStudy(
            "Not all shards are here:\n" + absent +
            "Nothing was written. Run and name them, or ask for a partial merge "
            "(--partial).");
    StoreReader all(std::move(shards));
    const std::vector<WallKey> missing = missing_walls(head, all.statuses());
    if (!missing.empty() && !partial)
        throw BadStoredStudy(
            std::to_string(missing.size()) +
            " walls are in no shard. Nothing was written. Finish the shards, or ask "
            "for a partial merge (--partial):\n" +
            list_of(missing));
    RowSource source = all.walls();
    source.row = [&](std::size_t i) {
        WallRow row = all.row(i);
        if (check) check(all.file_of(i), row);
        return row;
    };
    write_wall_file(out, head, source);
}

} // namespace app
