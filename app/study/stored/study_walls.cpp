#include "app/study/stored/study_walls.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/pushed/pier_columns.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/stored_study.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/turned_walls.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "fragility/curve/resampled_curve.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace app {
namespace {

/// Columns of the facts that a reading needs, looked up once. Files of earlier versions have
/// not all.
struct Columns {
    std::size_t rotation, sliding, cracked, outcome;
    std::optional<std::size_t> spalled, crushed_area, turning, settled, solver_error,
        points_error;
};

/// Place of the first whose `member` is this name.
template <class Range, class Member>
std::optional<std::size_t> place_of(const Range& range, std::string_view name, Member member)
{
    const auto at = std::ranges::find(range, name, member);
    if (at == range.end()) return {};
    return at - range.begin();
}

Columns columns_of(const std::filesystem::path& file, const StoreHead& head)
{
    refuse_histories(file.string(), head);
    const auto needed = [&](const std::vector<Column>& columns, std::string_view name) {
        const auto place = place_of(columns, name, &Column::name);
        if (!place)
            throw BadStoredStudy("'" + file.string() + "' has no column " + std::string(name) +
                                 "; run the study again into another file");
        return *place;
    };
    return {needed(head.responses, "rotation_share"),
            needed(head.responses, "sliding_share"),
            needed(head.counts, "cracked_units"),
            needed(head.counts, "outcome"),
            place_of(head.counts, "spalled_units", &Column::name),
            place_of(head.responses, "crushed_area", &Column::name),
            place_of(head.responses, "turning_share", &Column::name),
            place_of(head.counts, "settled", &Column::name),
            place_of(head.responses, "solver_error", &Column::name),
            place_of(head.responses, "points_error", &Column::name)};
}

std::vector<PierReading> piers_of_row(const StudyWalls& all, const ReadingRules& rules,
                                      const WallRow& row, const fragility::Curve& curve)
{
    const std::vector<PierFacts> facts = pier_facts_of(row.piers, all.head.piers);
    if (facts.size() != all.piers.size() || facts.empty()) return {};
    return read_piers({rules, all.pier_rules.codes}, all.piers, facts, curve);
}

StudyWall read_wall(const StudyWalls& all, const ReadingRules& rules, const Columns& c,
                    const WallRow& row, Keep keep)
{
    StudyWall w;
    w.key = row.key;
    w.failed = row.status != kWallOk;
    w.reason = row.reason;
    if (keep != Keep::readings)
        for (const StoredInput& input : all.inputs) w.inputs.push_back(shown_value(input, row));
    if (keep == Keep::everything) w.drawn = row.inputs;
    if (w.failed) {
        w.reading = not_read(rules, "the wall failed");
        return w;
    }
    if (c.solver_error) w.solver_error = row.responses[*c.solver_error];
    if (c.points_error) w.points_error = row.responses[*c.points_error];
    w.mechanism.rotation_share = row.responses[c.rotation];
    w.mechanism.sliding_share = row.responses[c.sliding];
    if (c.turning) w.mechanism.turning_share = row.responses[*c.turning];
    w.mechanism.cracked_units = static_cast<int>(row.counts[c.cracked]);
    if (c.spalled) w.mechanism.spalled_units = static_cast<int>(row.counts[*c.spalled]);
    if (c.crushed_area) w.mechanism.crushed_area = row.responses[*c.crushed_area];
    const bool came_down =
        row.counts[c.outcome] == static_cast<std::int64_t>(dem::Outcome::lost_equilibrium);
    const bool settled = c.settled && row.counts[*c.settled] != 0;
    const fragility::Curve curve{row.curve.displacement, row.curve.force, came_down};
    const std::vector<PierReading> piers = piers_of_row(all, rules, row, curve);
    w.reading = read(curve, w.mechanism, piers.empty() ? rules : with_piers(rules, piers),
                     settled, w.solver_error);
    for (const PierReading& p : piers)
        w.piers.push_back({mode_text(p), p.drift, p.facts.slenderness, p.facts.normal_at_peak,
                           p.facts.shear_at_peak});
    w.spandrels =
        read_spandrels(all.spandrels, spandrel_facts_of(row.spandrels, all.head.spandrels));
    if (keep == Keep::readings) return w;
    if (w.reading.no_reading.empty()) {
        const fragility::Backbone b =
            capacity_curve({row.curve.displacement, row.curve.force}, rules);
        w.forces = fragility::resampled({b.displacement, b.force}, all.step, kCurveSteps + 1);
    }
    if (!all.pushed_one_way)
        w.cycles = fragility::cycles({row.curve.displacement, row.curve.force});
    if (keep == Keep::everything) w.curve = row.curve;
    return w;
}

/// Throws BadStoredStudy naming file and wall if its curve is none: a push one way that turns
/// back.
StudyWall wall_of(const StudyWalls& all, const Columns& c, const std::filesystem::path& file,
                  const WallRow& row, Keep keep)
{
    ReadingRules rules = all.rules;
    if (round_of(all.head, row.key) == Round::turned) rules.direction = -rules.direction;
    try {
        return read_wall(all, rules, c, row, keep);
    } catch (const std::invalid_argument& bad) {
        damaged(file, wall_name(row.key) + ": " + bad.what());
    }
}

void check_overrides(std::span<const std::string> overrides)
{
    for (const std::string& o : overrides)
        if (!o.starts_with("fragility.") && !o.starts_with("calibration."))
            throw ConfigError("--set", 0, o.substr(0, o.find('=')),
                              "the walls have been pushed already; only fragility.* (and in "
                              "calibrate calibration.*) can be set here");
}

void add_wall(StudyLevel& level, StudyWall&& wall)
{
    (wall.failed ? level.failed_walls : level.walls).push_back(std::move(wall));
}

/// Joins the two pushes of each wall; a wall without one of them has not been run yet.
void join_ways(StudyWalls& walls, std::map<WallKey, StudyWall>&& own,
               std::map<WallKey, StudyWall>&& turned)
{
    for (auto& [key, wall] : own) {
        StudyLevel& level = walls.levels.at(key.level);
        const auto other = turned.find(key);
        if (other == turned.end())
            ++level.missing;
        else
            add_wall(level,
                     with_other_way(std::move(wall), std::move(other->second), walls.rules));
    }
}

/// As prescribed.
void add_marginals(const std::vector<RandomInput>& given, std::vector<StoredInput>& inputs)
{
    for (StoredInput& input : inputs)
        for (const RandomInput& random : given)
            if (random.key == input.key) input.marginal = random.marginal;
}

/// Everything but the walls.
StudyWalls study_of(const std::filesystem::path& file, const StoreHead& head,
                    std::span<const std::string> overrides)
{
    StudyWalls walls;
    walls.name = file.filename().string();
    walls.head = head;
    walls.shard = head.shards > 1;
    if (walls.shard)
        walls.name +=
            ", shard " + std::to_string(head.shard + 1) + " of " + std::to_string(head.shards);
    walls.study = stored_study(file, head, overrides);
    walls.rules = reading_rules(walls.study);
    walls.piers = piers_of(head.piers);
    walls.spandrels = spandrels_of(head.spandrels);
    if (!walls.piers.empty()) walls.pier_rules = pier_rules(walls.study.fragility, walls.rules);
    walls.rules.by_piers = !walls.piers.empty();
    walls.states = state_names(walls.rules);
    walls.inputs = stored_inputs(head.inputs);
    add_marginals(walls.study.random, walls.inputs);
    walls.height = walls.rules.height;
    walls.pushed_one_way = walls.rules.direction != 0;
    walls.step = push_way(walls.study.load).farthest / static_cast<double>(kCurveSteps);
    walls.shared = walls.study.uq.shared && own_levels(head) > 1;
    for (std::uint32_t l = 0; l < own_levels(head); ++l)
        walls.levels.push_back({head.levels[l].vertical_stress, {}, {}, 0});
    return walls;
}

} // namespace

StudyWalls read_study_walls(const std::filesystem::path& file,
                            std::span<const std::string> overrides, Keep keep)
{
    check_overrides(overrides);
    StoreReader reader(file);
    StudyWalls walls = study_of(file, reader.head(), overrides);
    const Columns c = columns_of(file, reader.head());
    const bool both = has_turned(walls.head);
    std::map<WallKey, StudyWall> own, turned; // of a study of both directions
    reader.for_each_row([&](const WallRow& row) {
        StudyWall wall = wall_of(walls, c, file, row, keep);
        if (both)
            own.emplace(row.key, std::move(wall));
        else
            add_wall(walls.levels.at(row.key.level), std::move(wall));
    });
    // Inputs and curve are those of the wall's own row.
    const Keep readings = keep == Keep::everything ? Keep::means : keep;
    reader.for_each_turned_row([&](const WallRow& row) {
        turned.emplace(own_key(walls.head, row.key), wall_of(walls, c, file, row, readings));
    });
    join_ways(walls, std::move(own), std::move(turned));
    reader.for_each_audit_row([&](const WallRow& row) {
        StudyWall wall = wall_of(walls, c, file, row, Keep::readings);
        wall.key = own_key(walls.head, row.key);
        walls.levels.at(wall.key.level).audit.push_back(std::move(wall));
    });
    for (const WallKey key : missing_walls(walls.head, reader.statuses())) {
        if (round_of(walls.head, key) == Round::turned) continue; // join_ways counts its wall
        StudyLevel& level = walls.levels.at(own_key(walls.head, key).level);
        ++(is_audit(walls.head, key) ? level.audit_missing : level.missing);
    }
    return walls;
}

WallCheck readable_walls(const std::filesystem::path& file)
{
    const StoreHead head = read_head(file);
    return [study = study_of(file, head, {}), columns = columns_of(file, head)](
               const std::filesystem::path& from, const WallRow& wall) {
        static_cast<void>(wall_of(study, columns, from, wall, Keep::readings));
    };
}

WallList walls_of(const StudyLevel& level, int mode)
{
    WallList walls;
    for (const StudyWall& w : level.walls)
        if (mode == kAllModes || mode_of(w) == mode) walls.push_back(&w);
    return walls;
}

WallList all_walls(const StudyWalls& study)
{
    WallList all;
    for (const StudyLevel& level : study.levels)
        for (const auto* const walls : {&level.walls, &level.failed_walls})
            for (const StudyWall& w : *walls) all.push_back(&w);
    std::ranges::sort(all, {}, &StudyWall::key);
    return all;
}

std::map<std::string, std::vector<WallKey>> failures(const StudyWalls& study)
{
    std::map<std::string, std::vector<WallKey>> why;
    for (const StudyLevel& level : study.levels)
        for (const StudyWall& w : level.failed_walls) why[w.reason].push_back(w.key);
    return why;
}

std::string named(const StudyWalls& study, const std::vector<WallKey>& walls, std::size_t most)
{
    std::string text;
    for (std::size_t i = 0; i < std::min(most, walls.size()); ++i)
        text += (i > 0 ? ", " : "") + stress_text(study.levels[walls[i].level].stress) +
                " sample " + std::to_string(walls[i].sample);
    return text;
}

std::string trouble_text(const StudyWalls& walls)
{
    constexpr std::size_t kNamed = 5;
    std::string text;
    for (const auto& [reason, keys] : failures(walls))
        text += std::to_string(keys.size()) + " failed: " + reason + " (" +
                named(walls, keys, kNamed) + (keys.size() > kNamed ? ", ...)\n" : ")\n");
    std::size_t missing = 0, all = 0;
    for (const StudyLevel& level : walls.levels) {
        missing += level.missing;
        all += level.walls.size() + level.failed_walls.size() + level.missing;
    }
    if (missing > 0)
        text +=
            std::to_string(missing) + " of " + std::to_string(all) +
            (walls.shard ? " walls are not in this shard\n" : " walls have not been run yet\n");
    if (const std::string other = other_revision_text(walls.head); !other.empty())
        text += other + "\n";
    return text;
}

std::optional<std::size_t> input_of(const StudyWalls& study, std::string_view key)
{
    return place_of(study.inputs, key, &StoredInput::key);
}

std::vector<int> modes_of(const StudyWalls& study)
{
    if (study.study.fragility.mode.modes == dem::ModeRule::paper) return {kRocking, kMixed};
    return {kRocking, kSliding, kMixed};
}

const char* mode_name(int mode)
{
    return mode == kAllModes ? "all" : name(static_cast<dem::FailureMode>(mode)).data();
}

} // namespace app
