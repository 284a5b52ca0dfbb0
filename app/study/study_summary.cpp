#include "app/study/study_summary.hpp"

#include "app/input/number_text.hpp"
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

std::string with_error(const uq::Estimate& e, double scale, int digits)
{
    return fixed(e.value * scale, digits) + " +- " + fixed(e.std_error * scale, digits);
}

std::string percent(double share) { return fixed(100.0 * share, 0); }

std::vector<std::string> cells(double stress, const Level& level)
{
    const std::size_t n = level.rocking + level.mixed;
    std::vector<std::string> row = {number(stress * 1e-6, 12), std::to_string(n),
                                    std::to_string(level.failed)};
    // A push that turns back has no reading: its walls are sound, their peaks are not defined.
    const std::vector<double> peaks = uq::sound_values(level.peak).values;
    if (peaks.size() >= 2) {
        const uq::Estimate mean = uq::estimate_mean(peaks), sd = uq::estimate_sd(peaks);
        row.push_back(with_error(mean, 1e-3, 1));
        row.push_back(fixed(sd.value / mean.value, 2));
    } else {
        row.push_back(peaks.empty() ? "" : fixed(peaks.front() * 1e-3, 1));
        row.push_back("");
    }
    if (n > 0) {
        const uq::Estimate p = uq::estimate_probability(level.rocking, n, level.failed);
        row.push_back(percent(p.value) + " [" + percent(p.interval.lower) + ", " +
                      percent(p.interval.upper) + "]");
    } else {
        row.emplace_back();
    }
    row.push_back(level.ultimate.size() >= 2
                      ? with_error(uq::estimate_mean(level.ultimate), 1e3, 1)
                      : "");
    row.push_back(std::to_string(level.ultimate.size()));
    row.push_back(std::to_string(level.censored));
    return row;
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
        "Walls per vertical stress. Errors are standard errors of independent samples "
        "(a Latin hypercube has less); intervals 95 %, failed walls either way. "
        "Ultimate: where the force first comes down to 80 % of the peak, mean of those "
        "observed.";
    s.table.head = {"stress [MPa]", "walls",         "failed",   "peak [kN]", "COV",
                    "rocking [%]",  "ultimate [mm]", "observed", "censored"};
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
