#include "app/shake/history_row.hpp"

#include "app/shake/shake_files.hpp"
#include "app/study/stored/history_names.hpp"
#include "dem/scene/mechanism/mechanism.hpp"
#include "fragility/curve/drift.hpp"
#include "ground/intensity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace app {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// A history with the mechanism of where it was farthest out.
struct ReadHistory {
    const ShakenHistory& h;
    dem::Mechanism farthest;
};

struct HistoryResponse {
    const char* name;
    const char* unit;
    const char* meaning;
    double (*read)(const ReadHistory&);
};

struct HistoryCount {
    const char* name;
    const char* meaning;
    std::int64_t (*read)(const ReadHistory&);
};

bool fell(const ReadHistory& r) { return r.h.result.outcome == dem::ShakeOutcome::collapsed; }

// clang-format off
constexpr std::array kHistoryResponses = {
    HistoryResponse{"max_drift", "-", "largest displacement of the top from its place at rest, over its height; of a wall that fell, up to there",
        [](const ReadHistory& r) { return fragility::drift(r.h.result.most_displacement, r.h.result.top_height); }},
    HistoryResponse{"max_drift_time", "s", "when", [](const ReadHistory& r) { return r.h.result.most_at; }},
    HistoryResponse{"residual_drift", "-", "after the shaking: mean of the last second of the free vibration; not of a wall that fell",
        [](const ReadHistory& r) { return fell(r) ? kNoValue : fragility::drift(r.h.result.residual_displacement, r.h.result.top_height); }},
    HistoryResponse{"collapse_time", "s", "when the wall had come down by 2 % of its height; only of one that fell",
        [](const ReadHistory& r) { return fell(r) ? r.h.result.collapse_time : kNoValue; }},
    HistoryResponse{"first_opening", "s", "when the first dry contact opened or closed; 0: none", [](const ReadHistory& r) { return r.h.result.first_opening; }},
    HistoryResponse{"last_opening", "s", "when the last one did", [](const ReadHistory& r) { return r.h.result.last_opening; }},
    HistoryResponse{"end", "s", "of the history", [](const ReadHistory& r) { return r.h.result.end; }},
    HistoryResponse{"rotation_share", "-", "rotation of the beam x height / displacement, where the wall turned back from its largest displacement or came down",
        [](const ReadHistory& r) { return r.farthest.rotation_share; }},
    HistoryResponse{"sliding_share", "-", "slip of the closed bed joints, summed over the courses / displacement, there",
        [](const ReadHistory& r) { return r.farthest.sliding_share; }},
    HistoryResponse{"turning_share", "-", "rotation of the blocks x height / displacement, there",
        [](const ReadHistory& r) { return r.farthest.turning_share; }},
    HistoryResponse{"uplift", "-", "largest share of the lowest joint above what the ground holds that was open",
        [](const ReadHistory& r) { return r.h.result.uplift; }},
    HistoryResponse{"pushed_limit", "-", "ultimate drift of the same wall when it is pushed, or where that push ended; only with shaking.push",
        [](const ReadHistory& r) { return r.h.pushed_limit; }},
    HistoryResponse{"ground_work", "J", "of the ground on the wall", [](const ReadHistory& r) { return r.h.result.ground_work; }},
    HistoryResponse{"fall_work", "J", "of weight and vertical load", [](const ReadHistory& r) { return r.h.result.fall_work; }},
    HistoryResponse{"kinetic_energy", "J", "at the end", [](const ReadHistory& r) { return r.h.result.energy.kinetic; }},
    HistoryResponse{"elastic_energy", "J", "of blocks and contacts, at the end", [](const ReadHistory& r) { return r.h.result.energy.elastic; }},
    HistoryResponse{"friction_energy", "J", "lost in slip", [](const ReadHistory& r) { return r.h.result.energy.friction; }},
    HistoryResponse{"fracture_energy", "J", "lost in cracks of units", [](const ReadHistory& r) { return r.h.result.energy.fracture; }},
    HistoryResponse{"damping_energy", "J", "lost in dashpots of contacts", [](const ReadHistory& r) { return r.h.result.energy.damping; }},
    HistoryResponse{"energy_residual", "-", "largest error of the energy balance over the energy that passed", [](const ReadHistory& r) { return r.h.result.residual; }},
    HistoryResponse{"time_step", "s", "of the solver", [](const ReadHistory& r) { return r.h.result.time_step; }},
    HistoryResponse{"factor", "-", "on the record", [](const ReadHistory& r) { return r.h.motion.factor; }},
};

constexpr std::array kHistoryCounts = {
    HistoryCount{"outcome", "0 stood, 1 fell, 2 was not at rest before the ground moved, 3 numbers not finite, 4 energy astray, 5 no wall",
        [](const ReadHistory& r) { return r.h.no_wall.empty() ? static_cast<std::int64_t>(r.h.result.outcome) : kNoWallToShake; }},
    HistoryCount{"wall", "sample of the random values, from 0", [](const ReadHistory& r) { return static_cast<std::int64_t>(r.h.of.wall); }},
    HistoryCount{"record", "in shaking.records, from 0", [](const ReadHistory& r) { return static_cast<std::int64_t>(r.h.of.record); }},
    HistoryCount{"intensity", "in shaking.intensities, from 0", [](const ReadHistory& r) { return static_cast<std::int64_t>(r.h.of.intensity); }},
    HistoryCount{"overturned", "1: fell as a whole", [](const ReadHistory& r) { return std::int64_t{r.h.result.overturned}; }},
    HistoryCount{"still", "1: at the end nothing moved any more", [](const ReadHistory& r) { return std::int64_t{r.h.result.still}; }},
    HistoryCount{"cracked_units", "cracked through", [](const ReadHistory& r) { return std::int64_t{r.farthest.cracked_units}; }},
    HistoryCount{"step_reductions", "times the step was halved", [](const ReadHistory& r) { return std::int64_t{r.h.result.step_reductions}; }},
    HistoryCount{"steps", "of the solver", [](const ReadHistory& r) { return std::int64_t{r.h.result.steps}; }},
};
// clang-format on

std::string measure_column(const ground::Measure& measure)
{
    std::string name = std::string(kMeasureColumns) + measure_text(measure);
    std::ranges::replace(name, ' ', '_');
    std::ranges::replace(name, ',', '+');
    return name;
}

/// Unit of a measure in SI.
const char* si_unit_of(const ground::Measure& measure)
{
    using Kind = ground::MeasureKind;
    switch (measure.kind) {
    case Kind::pga:
    case Kind::sa:
    case Kind::avg_sa:
        return "m/s2";
    case Kind::pgd:
        return "m";
    case Kind::duration:
        return "s";
    case Kind::rocking_pga:
    case Kind::rocking_pgv:
        return "-";
    default:
        return "m/s";
    }
}

std::string why_history_failed(const ShakenHistory& h)
{
    if (!h.no_wall.empty()) return "no wall can be made of the values drawn: " + h.no_wall;
    switch (h.result.outcome) {
    case dem::ShakeOutcome::unsettled:
        return "the wall does not stand at rest under its loads before the ground moves";
    case dem::ShakeOutcome::not_finite:
        return "the numbers of this history are not finite";
    default:
        return "the energy ledger does not close at any step tried";
    }
}

} // namespace

bool failed(const ShakenHistory& h) { return !h.no_wall.empty() || shake_failed(h.result); }

std::vector<Column> history_responses(const HistoryPlan& plan)
{
    std::vector<Column> columns;
    for (const HistoryResponse& c : kHistoryResponses)
        columns.push_back({c.name, c.unit, c.meaning});
    for (const ground::Measure& m : plan.measures)
        columns.push_back(
            {measure_column(m), si_unit_of(m), "intensity of the horizontal motion, scaled"});
    return columns;
}

std::vector<Column> history_counts()
{
    std::vector<Column> columns;
    for (const HistoryCount& c : kHistoryCounts) columns.push_back({c.name, "-", c.meaning});
    return columns;
}

WallRow history_row(WallKey key, const WallDraw& draw, const HistoryPlan& plan,
                    const ShakenHistory& h)
{
    const bool bad = failed(h);
    ReadHistory r{h, {}};
    if (!bad) r.farthest = dem::mechanism(h.result.at_most, h.result.top_height);
    WallRow row;
    row.key = key;
    row.inputs = flattened(draw);
    for (const HistoryResponse& c : kHistoryResponses) {
        const double x = bad ? kNoValue : c.read(r);
        row.responses.push_back(std::isfinite(x) ? x : kNoValue);
    }
    for (const ground::Measure& m : plan.measures)
        row.responses.push_back(intensity(h.motion.horizontal, m));
    for (const HistoryCount& c : kHistoryCounts) row.counts.push_back(c.read(r));
    row.status = bad ? 1 + static_cast<std::int32_t>(row.counts.front()) : kWallOk;
    row.reason = bad ? why_history_failed(h) : "";
    row.cost = {h.seconds};
    return row;
}

} // namespace app
