#include "app/study/stored/history_summary.hpp"

#include "app/output/table/cells.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace app {
namespace {

double middle_of(std::vector<double> x)
{
    if (x.empty()) return kUnknown;
    const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
    std::ranges::nth_element(x, middle);
    return *middle;
}

Row summary_row(double stress, Number intensity,
                const std::vector<const StoredHistory*>& histories)
{
    std::size_t fell = 0, bad = 0;
    std::array<std::size_t, 3> modes{};
    std::vector<double> drifts, residuals; // of a wall that fell: larger than any
    double seconds = 0.0;
    for (const StoredHistory* h : histories) {
        seconds += h->seconds;
        if (h->failed) {
            ++bad;
            continue;
        }
        fell += h->fell ? 1 : 0;
        ++modes[static_cast<std::size_t>(h->mode)];
        drifts.push_back(h->fell ? HUGE_VAL : 100.0 * h->max_drift);
        residuals.push_back(h->fell ? HUGE_VAL : 100.0 * std::abs(h->residual_drift));
    }
    const auto middle = [](const std::vector<double>& x) {
        const double m = middle_of(x);
        return std::isfinite(m) ? plain_number(m, 3) : Number{};
    };
    return {stress_cell(stress),
            intensity,
            count(histories.size()),
            count(bad),
            middle(drifts),
            middle(residuals),
            count(fell),
            count(modes[0]),
            count(modes[1]),
            count(modes[2]),
            plain_number(
                seconds / static_cast<double>(std::max<std::size_t>(1, histories.size())), 2)};
}

} // namespace

HistorySummary history_summary(const StoredHistories& all)
{
    HistorySummary s;
    s.table.title = "Shaken walls";
    s.table.caption =
        "Histories by stress and intensity. Medians are those of all histories with numbers, "
        "walls that fell above all others; empty where half of "
        "them fell. Modes: how the wall moved where it turned back from its largest "
        "displacement, or fell.";
    s.table.head = {"stress [MPa]",
                    intensity_head(all.at),
                    "histories",
                    "failed",
                    "median drift [%]",
                    "median residual [%]",
                    "fell",
                    "rocking",
                    "sliding",
                    "mixed",
                    {"seconds of a core", kProgramsOnly}};
    s.table.keys = 2;
    for (const HistoryLevel& level : all.levels) {
        std::map<std::size_t, std::vector<const StoredHistory*>> by;
        for (const StoredHistory& h : level.histories) {
            by[h.intensity].push_back(&h);
            s.failed += h.failed ? 1 : 0;
        }
        for (const auto& [intensity, histories] : by)
            s.table.rows.push_back(
                summary_row(level.stress, intensity_cell(all.at, intensity), histories));
    }
    s.remarks = history_troubles(all);
    return s;
}

} // namespace app
