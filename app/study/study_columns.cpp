#include "app/study/study_columns.hpp"

#include "app/input/units.hpp"
#include "app/text/number_text.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace app {
namespace {

constexpr double kNotDefined = std::numeric_limits<double>::quiet_NaN();

/// A column and how it is read off a wall.
struct Response {
    const char* name;
    const char* unit;
    const char* meaning;
    double (*read)(const PushedWall&);
};

struct Count {
    const char* name;
    const char* unit;
    const char* meaning;
    std::int64_t (*read)(const PushedWall&);
};

/// The curve of a wall as read for the file: of a push that turns back always the mean
/// backbone, so that facts do not follow fragility.backbone.
const WallReading& fact_reading(const PushedWall& w)
{
    const auto& backbones = w.reading.backbones;
    return backbones.empty() ? w.reading
                             : backbones.at(static_cast<std::size_t>(fragility::Side::mean));
}

// clang-format off
constexpr std::array kResponses = {
    Response{"peak_force", "N", "largest horizontal load; of a push that turns back, this and the next two are of the mean backbone",
        [](const PushedWall& w) { return peak_force(fact_reading(w)); }},
    Response{"peak_displacement", "m", "of the load line at the first largest load",
        [](const PushedWall& w) { return peak_displacement(fact_reading(w)); }},
    Response{"secant_stiffness", "N/m", "at 30 % of the peak",
        [](const PushedWall& w) { return fact_reading(w).stiffness.value_or(kNotDefined); }},
    Response{"last_displacement", "m", "where the curve ends",
        [](const PushedWall& w) { return w.displacement.empty() ? kNotDefined : w.displacement.back(); }},
    Response{"settlement", "m", "of the beam under vertical load alone, positive down",
        [](const PushedWall& w) { return w.result.settlement; }},
    Response{"rotation_share", "-", "rotation of the beam x height / displacement: 1 for pure rocking; like the two columns of cracks at the end; with finite displacements where the force came down to fragility.ultimate_share, or, where it did not, of the movement since half of the way",
        [](const PushedWall& w) { return w.mechanism.rotation_share; }},
    Response{"sliding_share", "-", "slip of the closed bed joints, summed over the courses / displacement",
        [](const PushedWall& w) { return w.mechanism.sliding_share; }},
    Response{"turning_share", "-", "rotation of the blocks x height / displacement: 1 too for piers that rock and for a wall in double bending",
        [](const PushedWall& w) { return w.mechanism.turning_share; }},
    Response{"work", "J", "of all loads, at the end", [](const PushedWall& w) { return w.result.energy.work; }},
    Response{"elastic_energy", "J", "of blocks and contacts, at the end", [](const PushedWall& w) { return w.result.energy.elastic; }},
    Response{"friction_energy", "J", "lost in slip", [](const PushedWall& w) { return w.result.energy.friction; }},
    Response{"fracture_energy", "J", "lost in cracks of units", [](const PushedWall& w) { return w.result.energy.fracture; }},
    Response{"crushing_energy", "J", "lost in contacts that crush", [](const PushedWall& w) { return w.result.energy.crushing; }},
    Response{"crushed_area", "m2", "of contacts that have lost all their compressive strength", [](const PushedWall& w) { return w.mechanism.crushed_area; }},
    Response{"energy_residual", "-", "largest share of the work that the ledger misses, anywhere",
        energy_residual},
    Response{"solver_error", "-", "estimated error of the peak force by the speed of the drive", solver_error},
    Response{"step_fraction", "-", "step used, of the proven stable one",
        [](const PushedWall& w) { return w.result.step_fraction; }},
};

constexpr std::array kCounts = {
    Count{"outcome", "-", "",
        [](const PushedWall& w) { return static_cast<std::int64_t>(w.result.outcome); }},
    Count{"cracked_units", "-", "units cracked through", [](const PushedWall& w) { return std::int64_t{w.mechanism.cracked_units}; }},
    Count{"cracked_contacts", "-", "contact points in units with D = 1", [](const PushedWall& w) { return std::int64_t{w.mechanism.cracked_contacts}; }},
    Count{"spalled_units", "-", "units that have lost parts smaller than a quarter", [](const PushedWall& w) { return std::int64_t{w.mechanism.spalled_units}; }},
    Count{"crushed_contacts", "-", "contact points of joints and units that have begun to crush", [](const PushedWall& w) { return std::int64_t{w.mechanism.crushed_contacts}; }},
    Count{"snap_back_contacts", "-", "in units, that break at once", [](const PushedWall& w) { return std::int64_t{w.result.snap_back_contacts}; }},
    Count{"settled", "-", "1: at rest under the vertical load before the push", [](const PushedWall& w) { return std::int64_t{w.result.settled}; }},
    Count{"step_reductions", "-", "times the step was halved", [](const PushedWall& w) { return std::int64_t{w.result.step_reductions}; }},
    Count{"steps", "-", "of the solver, those of steps given up included", [](const PushedWall& w) { return std::int64_t{w.result.cost.steps}; }},
};
// clang-format on

double finite_or_undefined(double x) { return std::isfinite(x) ? x : kNotDefined; }

template <class Table> std::vector<Column> columns_of(const Table& table)
{
    std::vector<Column> columns;
    for (const auto& c : table) columns.push_back({c.name, c.unit, c.meaning});
    return columns;
}

} // namespace

std::string site_meaning(bool joint, const uq::Site& site)
{
    return std::string(joint ? "of this joint ID" : "of this crack ID") +
           ", middle at x = " + number(site.x, 6) + " m, z = " + number(site.z, 6) + " m";
}

std::vector<Column> input_columns(const SamplePlan& plan)
{
    std::vector<Column> columns;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const std::string& key = plan.inputs[i].key;
        const std::string unit =
            plan.inputs[i].unit.empty() ? "-" : std::string(si_unit(plan.inputs[i].unit));
        const int sites = plan.values.inputs[i].sites;
        if (sites == 1) columns.push_back({key, unit, "of the whole wall"});
        const bool joint = plan.inputs[i].varies == Varies::by_joint;
        for (int id = 1; sites > 1 && id <= sites; ++id) {
            const uq::Site& site = (joint ? plan.joints : plan.cracks).at(id - 1);
            columns.push_back(
                {key + "." + std::to_string(id), unit, site_meaning(joint, site)});
        }
    }
    return columns;
}

std::vector<Column> response_columns() { return columns_of(kResponses); }
std::vector<Column> count_columns()
{
    std::vector<Column> columns = columns_of(kCounts);
    std::string& outcomes = columns.front().meaning; // "0 reached target, 1 decided, ..."
    for (std::size_t i = 0; i < dem::kOutcomeNames.size(); ++i)
        outcomes +=
            (i > 0 ? ", " : "") + std::to_string(i) + " " + std::string(dem::kOutcomeNames[i]);
    return columns;
}
std::vector<Column> cost_columns()
{
    return {{"solver_seconds", "s", "of one core; walls that share a register share it"}};
}

WallRow row_of(WallKey key, const WallDraw& draw, const PushedWall& wall)
{
    const bool failed = dem::failed(wall.result.outcome);
    WallRow row;
    row.key = key;
    row.status = failed ? 1 + static_cast<std::int32_t>(wall.result.outcome) : kWallOk;
    row.reason = failed ? wall.reading.no_reading : "";
    row.inputs = flattened(draw);
    for (const Response& r : kResponses)
        row.responses.push_back(failed ? kNotDefined : finite_or_undefined(r.read(wall)));
    for (const Count& c : kCounts) row.counts.push_back(c.read(wall));
    row.cost = {wall.result.cost.seconds};
    row.curve.displacement = wall.displacement;
    row.curve.force = wall.force;
    return row;
}

std::size_t column_of(const std::vector<Column>& columns, std::string_view name)
{
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].name == name) return i;
    throw std::out_of_range("no column " + std::string(name));
}

} // namespace app
