#include "app/report/report_study.hpp"

#include "app/input/number_text.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/mode_rule.hpp"
#include "app/study/study_columns.hpp"
#include "dem/scene/mechanism.hpp"

#include <exception>
#include <string_view>

namespace app {
namespace {

struct Columns {
    std::size_t peak, peak_at, ultimate, last, rotation, mode, reading, cracked;
};

Columns columns_of(const StoreHead& head)
{
    const auto response = [&](std::string_view n) { return column_of(head.responses, n); };
    const auto count = [&](std::string_view n) { return column_of(head.counts, n); };
    return {response("peak_force"),
            response("peak_displacement"),
            response("ultimate_displacement"),
            response("last_displacement"),
            response("rotation_share"),
            count("mode"),
            count("ultimate_reading"),
            count("cracked_units")};
}

ReportWall wall_of(const WallRow& row, const Columns& c)
{
    ReportWall w;
    w.row = row;
    w.failed = row.status != kWallOk;
    w.rocking = row.counts[c.mode] == static_cast<std::int64_t>(dem::FailureMode::rocking);
    w.peak = row.responses[c.peak];
    w.peak_at = row.responses[c.peak_at];
    w.ultimate = row.responses[c.ultimate];
    w.last = row.responses[c.last];
    w.cracked = static_cast<int>(row.counts[c.cracked]);
    if (w.failed) return w;
    w.reading = static_cast<fragility::Reading>(row.counts[c.reading]);
    // the thresholds of the stored mode
    w.slid = slid_whole({row.responses[c.rotation], 0.0, w.cracked, 0},
                        w.reading == fragility::Reading::observed, {});
    return w;
}

/// What only the study file knows. One of another version may not be readable: the rest of the
/// report does without.
void add_configuration(ReportStudy& r)
{
    try {
        r.study = read_study(parse_study_text(r.name, r.head.configuration));
    } catch (const std::exception& e) {
        r.no_study = e.what();
        return;
    }
    r.height = r.study->load.height;
    double from = 0.0;
    for (const double to : push_plan(*r.study).targets) {
        if (to < from) r.pushed_one_way = false;
        from = to;
    }
    for (StoredInput& input : r.inputs)
        for (const RandomInput& random : r.study->random)
            if (random.key == input.key) input.marginal = random.marginal;
}

} // namespace

std::vector<const ReportWall*> ReportStudy::sound(std::size_t level) const
{
    std::vector<const ReportWall*> found;
    for (const ReportWall& w : walls)
        if (w.row.key.level == level && !w.failed) found.push_back(&w);
    return found;
}

double ReportStudy::stress(std::size_t level) const
{
    return head.levels[level].vertical_stress * 1e-6;
}

std::string ReportStudy::stress_text(std::size_t level) const
{
    const std::string two = fixed(stress(level), 2);
    const std::string all = number(stress(level), 12);
    return (number(std::stod(two), 12) == all ? two : all) + " MPa";
}

ReportStudy read_report_study(const std::filesystem::path& file)
{
    StoreReader reader(file);
    ReportStudy r;
    r.name = file.stem().string();
    r.head = reader.head();
    r.inputs = stored_inputs(r.head.inputs);
    const Columns columns = columns_of(r.head);
    reader.for_each_row([&](const WallRow& row) { r.walls.push_back(wall_of(row, columns)); });
    r.missing = missing_walls(r.head, reader.statuses()).size();
    add_configuration(r);
    return r;
}

} // namespace app
