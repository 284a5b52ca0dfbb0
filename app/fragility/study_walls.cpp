#include "app/fragility/study_walls.hpp"

#include "app/input/config_error.hpp"
#include "app/input/number_text.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/resampled_curve.hpp"
#include "app/study/study_columns.hpp"
#include "dem/scene/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace app {
namespace {

struct Columns {
    std::size_t peak, ultimate, rotation, sliding, reading, cracked;
};

Columns columns_of(const StoreHead& head)
{
    const auto response = [&](std::string_view n) { return column_of(head.responses, n); };
    const auto count = [&](std::string_view n) { return column_of(head.counts, n); };
    return {response("peak_force"),     response("ultimate_displacement"),
            response("rotation_share"), response("sliding_share"),
            count("ultimate_reading"),  count("cracked_units")};
}

/// Limit states that no curve of this study has.
std::vector<fragility::LimitDisplacement> undefined(std::size_t n, std::string_view why)
{
    return std::vector<fragility::LimitDisplacement>(
        n, {0.0, fragility::Reading::not_defined, why});
}

StudyWall wall_of(const StudyWalls& all, const Columns& c, const WallRow& row)
{
    const FragilityInput& f = all.study.fragility;
    StudyWall w;
    w.key = row.key;
    w.rotation_share = row.responses[c.rotation];
    w.sliding_share = row.responses[c.sliding];
    w.cracked_units = static_cast<int>(row.counts[c.cracked]);
    w.peak_force = row.responses[c.peak];
    const auto reading = static_cast<fragility::Reading>(row.counts[c.reading]);
    const bool defined = reading != fragility::Reading::not_defined;
    w.ultimate = {defined ? row.responses[c.ultimate] : 0.0, reading, ""};
    w.dropped = reading == fragility::Reading::observed;
    const dem::Mechanism m{w.rotation_share, w.sliding_share, w.cracked_units, 0};
    w.mode = static_cast<int>(dem::failure_mode(m, w.dropped, f.mode));
    for (const StoredInput& input : all.inputs) w.inputs.push_back(shown_value(input, row));
    const fragility::Curve curve{row.curve.displacement, row.curve.force};
    const bool readable = all.pushed_one_way && !row.curve.displacement.empty();
    w.limits = readable ? read_states(curve, all.wanted, all.height)
                        : undefined(all.states.size(),
                                    all.pushed_one_way ? "no curve" : "the push turns back");
    if (readable) w.forces = resampled(row.curve, all.step, kCurveSteps + 1);
    return w;
}

void check_overrides(std::span<const std::string> overrides)
{
    for (const std::string& o : overrides)
        if (!o.starts_with("fragility."))
            throw ConfigError("--set", 0, o.substr(0, o.find('=')),
                              "the walls are there already; only fragility.* can be set here");
}

void add_wall(StudyWalls& walls, const Columns& c, const WallRow& row)
{
    StudyLevel& level = walls.levels.at(row.key.level);
    if (row.status != kWallOk) {
        ++level.failed;
        ++level.reasons[row.reason];
        return;
    }
    level.walls.push_back(wall_of(walls, c, row));
}

/// Farthest and whether it ever turns.
void read_way(StudyWalls& walls)
{
    double from = 0.0, farthest = 0.0;
    for (const double to : push_plan(walls.study).targets) {
        if (to < from) walls.pushed_one_way = false;
        farthest = std::max(farthest, to);
        from = to;
    }
    walls.step = farthest / static_cast<double>(kCurveSteps);
}

} // namespace

StudyWalls read_study_walls(const std::filesystem::path& file,
                            std::span<const std::string> overrides)
{
    check_overrides(overrides);
    StoreReader reader(file);
    const StoreHead& head = reader.head();
    StudyWalls walls;
    walls.name = file.filename().string();
    walls.shard = head.shards > 1;
    if (walls.shard)
        walls.name +=
            ", shard " + std::to_string(head.shard + 1) + " of " + std::to_string(head.shards);
    walls.study = read_study(
        with_overrides(parse_study_text(file.string(), head.configuration), overrides));
    walls.wanted = wanted_states(walls.study);
    walls.states = state_names(walls.wanted);
    walls.inputs = stored_inputs(head.inputs);
    walls.height = walls.study.load.height;
    walls.shared = walls.study.uq.shared && head.levels.size() > 1;
    read_way(walls);
    for (const StoreLevel& level : head.levels)
        walls.levels.push_back({level.vertical_stress, {}, 0, 0, {}});
    const Columns c = columns_of(head);
    reader.for_each_row([&](const WallRow& row) { add_wall(walls, c, row); });
    for (const WallKey key : missing_walls(head, reader.statuses()))
        ++walls.levels.at(key.level).missing;
    return walls;
}

const char* mode_name(int mode) { return mode == kRocking ? "rocking" : "mixed"; }

DriftData drift_data(const StudyWalls& walls)
{
    DriftData data;
    data.source = walls.name;
    data.drift =
        "Drift: displacement of the load line / its height, " + number(walls.height, 6) + " m";
    data.group_head = "stress [MPa]";
    data.modes = {mode_name(kRocking), mode_name(kMixed)};
    const FragilityInput& f = walls.study.fragility;
    data.options = {f.law, f.confidence, static_cast<std::size_t>(f.bootstrap),
                    walls.study.uq.seed};
    for (const StateName& s : walls.states) data.states.push_back({s.set, s.name, s.rule});
    for (const StudyLevel& level : walls.levels) {
        const double mpa = level.stress * 1e-6;
        DriftGroup group{number(mpa, 12) + " MPa", mpa, {}, level.failed, level.missing};
        for (const StudyWall& w : level.walls) {
            DriftWall wall{w.mode, {}};
            for (const auto& limit : w.limits)
                wall.limits.push_back(fragility::observation(limit, 100.0 / walls.height));
            group.walls.push_back(std::move(wall));
        }
        data.groups.push_back(std::move(group));
    }
    return data;
}

} // namespace app
