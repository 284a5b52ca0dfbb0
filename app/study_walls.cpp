#include "app/study_walls.hpp"

#include "app/config_error.hpp"
#include "app/number_text.hpp"
#include "app/store_reader.hpp"
#include "app/study_columns.hpp"
#include "app/study_keys.hpp"
#include "app/words.hpp"
#include "dem/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
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

void set_unit(WallInput& input, const std::string& stored)
{
    const bool modulus = input.key.ends_with("modulus");
    input.unit = stored;
    if (stored == "rad") {
        input.unit = "deg";
        input.scale = 180.0 / std::numbers::pi;
    } else if (stored == "Pa") {
        input.unit = modulus ? "GPa" : "MPa";
        input.scale = modulus ? 1e-9 : 1e-6;
    }
}

/// Columns "key", or "key.1", "key.2", ... side by side.
std::vector<WallInput> inputs_of(const std::vector<Column>& columns)
{
    std::vector<WallInput> inputs;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string& name = columns[i].name;
        const std::size_t dot = name.rfind('.');
        const bool numbered =
            dot != std::string::npos && dot + 1 < name.size() &&
            name.find_first_not_of("0123456789", dot + 1) == std::string::npos;
        const std::string key = numbered ? name.substr(0, dot) : name;
        if (numbered && !inputs.empty() && inputs.back().key == key) {
            ++inputs.back().count;
            continue;
        }
        WallInput input{key, "", 1.0, i, 1};
        set_unit(input, columns[i].unit);
        inputs.push_back(input);
    }
    return inputs;
}

double shown(const WallInput& input, const WallRow& row)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < input.count; ++i) sum += row.inputs[input.first + i];
    return input.scale * sum / static_cast<double>(input.count);
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
    w.mode =
        static_cast<int>(dem::failure_mode(m, w.dropped, {f.sliding_share, f.cracked_units}));
    for (const WallInput& input : all.inputs) w.inputs.push_back(shown(input, row));
    const fragility::Curve curve{row.curve.displacement, row.curve.force};
    const bool readable = all.pushed_one_way && !row.curve.displacement.empty();
    w.limits = readable ? read_states(curve, all.wanted, all.height)
                        : undefined(all.states.size(),
                                    all.pushed_one_way ? "no curve" : "the push turns back");
    if (readable) w.forces = resampled(row.curve, all.step, kCurveSteps + 1);
    return w;
}

/// The stored configuration without defaults that follow from other values: read back as numbers given
/// they need not pass the checks (rounded means of distributions). Lines keep their numbers.
std::string without_derived(std::string_view configuration)
{
    std::string kept, section;
    while (!configuration.empty()) {
        const std::size_t end = configuration.find('\n');
        const std::string_view line = configuration.substr(0, end);
        configuration.remove_prefix(end == line.npos ? configuration.size() : end + 1);
        const std::string_view words = trimmed(line);
        if (words.starts_with('[')) section = words.substr(1, words.find(']') - 1);
        const Key* const key =
            find_key(section + "." + std::string(trimmed(line.substr(0, line.find('=')))));
        const bool derived =
            words.ends_with("# default") && key != nullptr && key->derived.apply != nullptr;
        kept += (derived ? std::string() : std::string(line)) + "\n";
    }
    return kept;
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

std::vector<double> resampled(const WallCurve& curve, double step, std::size_t points)
{
    const auto& d = curve.displacement;
    std::vector<double> forces;
    std::size_t next = 0; // first point at or beyond x
    for (std::size_t i = 0; i < points && !d.empty(); ++i) {
        const double x = static_cast<double>(i) * step;
        if (x > d.back() * (1.0 + 1e-9)) break;
        while (next + 1 < d.size() && d[next] < x) ++next;
        const double x0 = next > 0 ? d[next - 1] : 0.0, x1 = d[next];
        const double f0 = next > 0 ? curve.force[next - 1] : 0.0, f1 = curve.force[next];
        const double t = x1 > x0 ? std::clamp((x - x0) / (x1 - x0), 0.0, 1.0) : 1.0;
        forces.push_back(f0 + t * (f1 - f0));
    }
    return forces;
}

StudyWalls read_study_walls(const std::filesystem::path& file,
                            std::span<const std::string> overrides)
{
    check_overrides(overrides);
    StoreReader reader(file);
    const StoreHead& head = reader.head();
    StudyWalls walls;
    walls.name = file.filename().string();
    walls.study = read_study(with_overrides(
        parse_study_text(file.string(), without_derived(head.configuration)), overrides));
    walls.wanted = wanted_states(walls.study);
    walls.states = state_names(walls.wanted);
    walls.inputs = inputs_of(head.inputs);
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

DriftData drift_data(const StudyWalls& walls)
{
    DriftData data;
    data.source = walls.name;
    data.drift =
        "Drift: displacement of the load line / its height, " + number(walls.height, 6) + " m";
    data.group_head = "stress [MPa]";
    data.modes = {"rocking", "mixed"};
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
