#include "app/study/study_summary.hpp"

#include "app/input/number_text.hpp"
#include "app/output/cells.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/study_columns.hpp"
#include "dem/scene/mechanism.hpp"
#include "fragility/curve_reading.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace app {
namespace {

/// Numbers of the walls under one stress. NaN: a wall that failed.
struct Level {
    std::vector<double> peak;     ///< [N]
    std::vector<double> ultimate; ///< those observed [m]
    std::size_t rocking = 0, mixed = 0, failed = 0, censored = 0;
};

struct Columns {
    std::size_t peak, ultimate, mode, reading;
};

void add(const WallRow& row, const Columns& c, Level& level)
{
    level.peak.push_back(row.responses[c.peak]);
    if (row.status != kWallOk) {
        ++level.failed;
        return;
    }
    const bool rocks =
        row.counts[c.mode] == static_cast<std::int64_t>(dem::FailureMode::rocking);
    ++(rocks ? level.rocking : level.mixed);
    const auto reading = static_cast<fragility::Reading>(row.counts[c.reading]);
    if (reading == fragility::Reading::observed)
        level.ultimate.push_back(row.responses[c.ultimate]);
    if (reading == fragility::Reading::censored) ++level.censored;
}

Number mean_cell(const std::vector<double>& values, double scale)
{
    if (values.empty()) return {};
    if (values.size() == 1) return plain_number(values.front() * scale, 1);
    const uq::Estimate e = uq::estimate_mean(values);
    return with_error(e.value * scale, e.std_error * scale, 1);
}

Number cov_cell(const std::vector<double>& values)
{
    if (values.size() < 2) return {};
    return plain_number(uq::estimate_sd(values).value / uq::estimate_mean(values).value, 2);
}

Row cells(double stress, const Level& level)
{
    const std::size_t n = level.rocking + level.mixed;
    // A push that turns back has no reading: its walls are sound, their peaks are not defined.
    const std::vector<double> peaks = uq::sound_values(level.peak).values;
    Number rocking;
    if (n > 0) {
        const uq::Estimate p = uq::estimate_probability(level.rocking, n, level.failed);
        rocking = with_interval(100.0 * p.value, 100.0 * p.interval.lower,
                                100.0 * p.interval.upper, 0);
    }
    return {given(stress * 1e-6),
            count(static_cast<double>(n)),
            count(static_cast<double>(level.failed)),
            mean_cell(peaks, 1e-3),
            cov_cell(peaks),
            rocking,
            mean_cell(level.ultimate, 1e3),
            count(static_cast<double>(level.ultimate.size())),
            count(static_cast<double>(level.censored))};
}

/// "2 walls failed: the energy ledger does not close ... (0.75 MPa sample 17, ...)"
std::string failures(const StoreHead& head,
                     const std::map<std::string, std::vector<WallKey>>& why)
{
    constexpr std::size_t kNamed = 5;
    std::string text;
    for (const auto& [reason, walls] : why) {
        text += std::to_string(walls.size()) + " failed: " + reason + " (";
        for (std::size_t i = 0; i < std::min(kNamed, walls.size()); ++i)
            text += (i > 0 ? ", " : "") +
                    number(head.levels[walls[i].level].vertical_stress * 1e-6, 12) +
                    " MPa sample " + std::to_string(walls[i].sample);
        text += walls.size() > kNamed ? ", ...)\n" : ")\n";
    }
    return text;
}

} // namespace

StudySummary summarise(const std::filesystem::path& file)
{
    StoreReader reader(file);
    const StoreHead& head = reader.head();
    const Columns c{column_of(head.responses, "peak_force"),
                    column_of(head.responses, "ultimate_displacement"),
                    column_of(head.counts, "mode"), column_of(head.counts, "ultimate_reading")};
    std::vector<Level> levels(head.levels.size());
    std::map<std::string, std::vector<WallKey>> why;
    StudySummary s;
    reader.for_each_row([&](const WallRow& row) {
        add(row, c, levels.at(row.key.level));
        if (row.status != kWallOk) why[row.reason].push_back(row.key);
    });
    s.table.caption =
        "Walls per vertical stress. Errors are standard errors of independent samples; a Latin "
        "hypercube has less. The 95 % interval counts the failed walls once as rocking and "
        "once "
        "as mixed. Ultimate: where the force first comes down to 80 % of the peak, as the mean "
        "of the walls on which that was observed.";
    s.table.head = {"stress [MPa]",
                    "walls",
                    "failed",
                    {"peak [kN]", kError},
                    "COV",
                    {"rocking [%]", kInterval},
                    {"ultimate [mm]", kError},
                    "observed",
                    "censored"};
    for (std::size_t i = 0; i < levels.size(); ++i) {
        s.table.rows.push_back(cells(head.levels[i].vertical_stress, levels[i]));
        s.failed += levels[i].failed;
    }
    s.remarks = failures(head, why);
    s.missing = missing_walls(head, reader.statuses()).size();
    if (s.missing > 0)
        s.remarks += std::to_string(s.missing) + " walls of the study are not in this file\n";
    return s;
}

} // namespace app
