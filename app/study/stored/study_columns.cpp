#include "app/study/stored/study_columns.hpp"

#include "app/input/study/units.hpp"
#include "app/reading/wall_numbers.hpp"
#include "app/text/number_text.hpp"

#include <cmath>
#include <stdexcept>

namespace app {
namespace {

/// The curve of a wall as read for the file: of a push that turns back always the mean
/// backbone, so that facts do not follow fragility.backbone.
const WallReading& fact_reading(const PushedWall& w)
{
    const auto& backbones = w.reading.backbones;
    return backbones.empty() ? w.reading
                             : backbones.at(static_cast<std::size_t>(fragility::Side::mean));
}

double finite_or_undefined(double x) { return std::isfinite(x) ? x : kNoNumber; }

std::vector<Column> columns_of(Kept kept)
{
    std::vector<Column> columns;
    for (const WallNumber& n : kWallNumbers)
        if (n.kept == kept)
            columns.push_back({std::string(n.name), std::string(n.unit.si), meaning(n)});
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

std::vector<Column> response_columns()
{
    std::vector<Column> columns = columns_of(Kept::as_response);
    columns.front().meaning +=
        "; of a push that turns back, this and the next two are of the mean backbone";
    return columns;
}

std::vector<Column> count_columns() { return columns_of(Kept::as_count); }

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
    const WallSource kept = source_of(wall, fact_reading(wall));
    for (const WallNumber& n : kWallNumbers) {
        if (n.kept == Kept::as_response)
            row.responses.push_back(failed ? kNoNumber : finite_or_undefined(value(n, kept)));
        if (n.kept == Kept::as_count)
            row.counts.push_back(static_cast<std::int64_t>(value(n, kept)));
    }
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
