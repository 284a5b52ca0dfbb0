#include "app/study/stored/stored_histories.hpp"

#include "app/store/hdf5/store_error.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/stored_study.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>

namespace app {
namespace {

/// Places of what a history is read from.
struct HistoryPlaces {
    std::size_t max_drift, residual_drift, collapse_time, uplift, pushed_limit, rotation,
        sliding, turning, outcome, wall, record, intensity, cracked, seconds;
    std::vector<std::size_t> measures;
};

HistoryPlaces places_of(const std::filesystem::path& file, const StoreHead& head)
{
    try {
        const auto response = [&](const char* name) { return column_of(head.responses, name); };
        const auto count = [&](std::string_view name) { return column_of(head.counts, name); };
        HistoryPlaces p{response("max_drift"),
                        response("residual_drift"),
                        response("collapse_time"),
                        response("uplift"),
                        response("pushed_limit"),
                        response("rotation_share"),
                        response("sliding_share"),
                        response("turning_share"),
                        count("outcome"),
                        count(kWallColumn),
                        count(kRecordColumn),
                        count(kIntensityColumn),
                        count("cracked_units"),
                        column_of(head.cost, "solver_seconds"),
                        {}};
        for (std::size_t i = 0; i < head.responses.size(); ++i)
            if (head.responses[i].name.starts_with(kMeasureColumns)) p.measures.push_back(i);
        return p;
    } catch (const std::out_of_range& bad) {
        throw BadStoredStudy("'" + file.string() + "' has " + bad.what() +
                             "; run the study again into another file");
    }
}

StoredHistory history_of_row(const std::filesystem::path& file, const StoredHistories& all,
                             const HistoryPlaces& p, const WallRow& row)
{
    StoredHistory h;
    h.key = row.key;
    const auto index = [&](std::size_t place, const char* what, std::size_t most) {
        const std::int64_t i = row.counts[place];
        if (i < 0 || static_cast<std::uint64_t>(i) >= most)
            damaged(file, wall_name(row.key) + " has no such " + what);
        return static_cast<std::size_t>(i);
    };
    h.wall = index(p.wall, "wall", kMostWalls);
    h.record = index(p.record, "record", all.records.size());
    h.intensity =
        index(p.intensity, "intensity", std::max<std::size_t>(1, all.at.values.size()));
    for (const std::size_t m : p.measures) h.measures.push_back(row.responses[m]);
    h.seconds = row.cost[p.seconds];
    h.failed = row.status != kWallOk;
    h.reason = row.reason;
    if (h.failed) return h;
    h.fell = row.counts[p.outcome] == kFell;
    h.max_drift = row.responses[p.max_drift];
    h.residual_drift = row.responses[p.residual_drift];
    h.collapse_time = row.responses[p.collapse_time];
    h.uplift = row.responses[p.uplift];
    h.pushed_limit = row.responses[p.pushed_limit];
    if (!(h.max_drift >= 0.0) || !(h.fell || std::isfinite(h.residual_drift)))
        damaged(file, wall_name(row.key) + " has no drift");
    dem::Mechanism m;
    m.rotation_share = row.responses[p.rotation];
    m.sliding_share = row.responses[p.sliding];
    m.turning_share = row.responses[p.turning];
    m.cracked_units = static_cast<int>(row.counts[p.cracked]);
    h.mode = dem::failure_mode(m, h.fell, all.study.fragility.mode);
    return h;
}

std::string text_of_measure(std::string_view column)
{
    std::string text(column.substr(kMeasureColumns.size()));
    // names have underscores of their own; in brackets they stand for blanks, and + for commas
    for (char& c : std::span(text).subspan(std::min(text.find('('), text.size())))
        c = c == '_' ? ' ' : c == '+' ? ',' : c;
    return text;
}

} // namespace

StoredHistories read_histories(const std::filesystem::path& file,
                               std::span<const std::string> overrides)
{
    for (const std::string& o : overrides)
        if (!o.starts_with("fragility."))
            throw ConfigError(
                "--set", 0, o.substr(0, o.find('=')),
                "the walls have been shaken already; only fragility.* can be set here");
    StoreReader reader(file);
    StoredHistories all;
    all.name = file.filename().string();
    all.head = reader.head();
    all.shard = all.head.shards > 1;
    if (all.shard)
        all.name += ", shard " + std::to_string(all.head.shard + 1) + " of " +
                    std::to_string(all.head.shards);
    if (!holds_histories(all.head))
        throw BadStoredStudy("'" + file.string() + "' holds no walls that were shaken");
    all.study = stored_study(file, all.head, overrides);
    all.at = shaken_intensities(all.study.shaking, all.study.source);
    for (const std::string& line : record_lines(all.head.identity))
        all.records.push_back(record_name(line));
    const HistoryPlaces places = places_of(file, all.head);
    for (const std::size_t m : places.measures) {
        all.measures.push_back(text_of_measure(all.head.responses[m].name));
        all.units.push_back(all.head.responses[m].unit);
    }
    for (const StoreLevel& level : all.head.levels)
        all.levels.push_back({level.vertical_stress, {}, 0});
    reader.for_each_row([&](const WallRow& row) {
        all.levels.at(row.key.level)
            .histories.push_back(history_of_row(file, all, places, row));
    });
    for (const WallKey key : missing_walls(all.head, reader.statuses()))
        ++all.levels.at(key.level).missing;
    return all;
}

std::string history_troubles(const StoredHistories& all)
{
    constexpr std::size_t kNamed = 3;
    std::map<std::string, std::vector<std::string>> why;
    std::size_t missing = 0, count = 0;
    for (const HistoryLevel& level : all.levels) {
        missing += level.missing;
        count += level.missing + level.histories.size();
        for (const StoredHistory& h : level.histories)
            if (h.failed)
                why[h.reason].push_back(stress_text(level.stress) + ", wall " +
                                        std::to_string(h.wall) + ", " + all.records[h.record] +
                                        intensity_text(all.at, h.intensity));
    }
    std::string text;
    for (const auto& [reason, names] : why) {
        text += std::to_string(names.size()) + " failed: " + reason + " (";
        for (std::size_t i = 0; i < std::min(kNamed, names.size()); ++i)
            text += (i > 0 ? "; " : "") + names[i];
        text += names.size() > kNamed ? "; ...)\n" : ")\n";
    }
    if (missing > 0)
        text += std::to_string(missing) + " of " + std::to_string(count) +
                (all.shard ? " histories are not in this shard\n"
                           : " histories have not been run yet\n");
    if (const std::string other = other_revision_text(all.head); !other.empty())
        text += other + "\n";
    return text;
}

} // namespace app
