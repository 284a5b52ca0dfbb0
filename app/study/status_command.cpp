#include "app/commands.hpp"

#include "app/output/picture/markup.hpp"
#include "app/output/table/cells.hpp"
#include "app/output/table/table.hpp"
#include "app/store/store_parts.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace app {
namespace {

namespace fs = std::filesystem;

struct Written {
    std::time_t last = 0; ///< of the file and its parts
    double bytes = 0.0;   ///< of all of them
};

void add_file(Written& all, const fs::path& file)
{
    struct stat facts {};
    if (::stat(file.c_str(), &facts) != 0) return; // a part that was merged meanwhile
    all.last = std::max(all.last, facts.st_mtime);
    all.bytes += static_cast<double>(facts.st_size);
}

Written written(const fs::path& file)
{
    Written all;
    add_file(all, file);
    for (const std::uint32_t part : part_numbers(file)) add_file(all, part_of(file, part));
    return all;
}

std::string utc(std::time_t when)
{
    std::tm parts{};
    std::array<char, 32> text{};
    if (::gmtime_r(&when, &parts) == nullptr) return "";
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

/// Walls of one level, by what became of them.
struct LevelCount {
    std::size_t done = 0, failed = 0;
};

Table level_counts(const StoreHead& head, const std::vector<WallStatus>& walls)
{
    std::vector<LevelCount> counts(head.levels.size());
    for (const WallStatus& w : walls)
        (w.status == kWallOk ? counts.at(w.key.level).done : counts.at(w.key.level).failed) +=
            1;
    std::vector<std::size_t> missing(head.levels.size());
    for (const WallKey& key : missing_walls(head, walls)) missing.at(key.level) += 1;
    Table t;
    t.head = {"stress [MPa]", "walls", "with a result", "failed", "to run", "of an audit"};
    if (has_turned(head)) t.head.emplace_back("other way");
    for (std::size_t i = 0; i < counts.size(); ++i) {
        Row row = {stress_cell(head.levels[i].vertical_stress),
                   count(head.levels[i].samples),
                   count(counts[i].done),
                   count(counts[i].failed),
                   count(missing[i]),
                   std::string(head.levels[i].slower > 1 ? "yes" : "no")};
        if (has_turned(head))
            row.emplace_back(std::string(head.levels[i].turned ? "yes" : "no"));
        t.rows.push_back(std::move(row));
    }
    return t;
}

std::string sessions_text(const StoreHead& head)
{
    std::string text;
    for (const StoreSession& s : head.sessions)
        text += "begun " + s.started + " by drystone " + s.program_version +
                (s.solver_revision.empty() ? "" : ", solver revision " + s.solver_revision) +
                ", on " + s.machine + ", " + s.settings + "\n";
    return text;
}

std::string inputs_text(const StoreHead& head)
{
    std::vector<std::string_view> names;
    for (const Column& c : head.inputs) names.push_back(c.name);
    constexpr std::size_t kMost = 12;
    if (names.empty()) return "no value is random\n";
    const std::string all = counted(names.size(), "random value", "random values");
    if (names.size() > kMost) return all + " for each wall\n";
    std::string text;
    for (const std::string_view name : names)
        text += (text.empty() ? ": " : ", ") + std::string(name);
    return all + " for each wall" + text + "\n";
}

} // namespace

int status_command(const Command& command)
{
    constexpr double kMegabyte = 1e6;
    check_is_study(command.study);
    const StoreReader reader(command.study);
    const StoreHead& head = reader.head();
    const Written file = written(command.study);
    const std::size_t there = reader.statuses().size();
    const std::uint64_t wanted = walls_wanted(head);
    const std::size_t missing = missing_walls(head, reader.statuses()).size();
    const std::string shard = head.shards > 1 ? ", shard " + std::to_string(head.shard + 1) +
                                                    " of " + std::to_string(head.shards)
                                              : "";
    std::cout << command.study << shard << ": " << there << " of " << wanted
              << (holds_histories(head) ? " histories, " : " walls, ")
              << (missing == 0      ? "all are there"
                  : head.shards > 1 ? "the others are those of other shards, or still to run"
                                    : "the same study command runs the others")
              << '\n'
              << as_text(level_counts(head, reader.statuses()), terminal_width())
              << wrapped(inputs_text(head), terminal_width()) << "last written "
              << utc(file.last) << ", " << fixed(file.bytes / kMegabyte, 1) << " MB\n"
              << wrapped(sessions_text(head), terminal_width());
    if (const std::string other = other_revision_text(head); !other.empty())
        std::cout << wrapped(other + "\n", terminal_width());
    return 0;
}

} // namespace app
