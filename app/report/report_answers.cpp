#include "app/report/report_parts.hpp"

#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "fragility/observed_quantile.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr std::size_t kMostAnswers = 6; ///< stresses: more hide the picture below

const char* const kNothing = "–";

std::string interval(double lower, double upper, int decimals)
{
    return " [" + fixed(lower, decimals) + ", " +
           (std::isfinite(upper) ? fixed(upper, decimals) : "…") + "]";
}

std::string peak_of(const StudyLevel& level, double confidence)
{
    std::vector<double> peaks;
    for (const StudyWall& w : level.walls)
        if (w.reading.peak) peaks.push_back(w.reading.peak->force * 1e-3);
    if (peaks.empty()) return kNothing;
    if (peaks.size() == 1) return fixed(peaks.front(), 1);
    const uq::Estimate e = uq::estimate_mean(peaks, confidence);
    return fixed(e.value, 1) + interval(e.interval.lower, e.interval.upper, 1);
}

/// "rocking 76 %, mixed 24 %"
std::string modes_of_level(const StudyLevel& level)
{
    std::array<std::size_t, kAllModes> n{};
    for (const StudyWall& w : level.walls) ++n.at(static_cast<std::size_t>(mode_of(w)));
    std::string text;
    for (int mode = 0; mode < kAllModes; ++mode) {
        const std::size_t walls = n.at(static_cast<std::size_t>(mode));
        if (walls == 0) continue;
        text += (text.empty() ? "" : ", ") + std::string(mode_name(mode));
        if (walls < level.walls.size())
            text += " " +
                    fixed(100.0 * static_cast<double>(walls) /
                              static_cast<double>(level.walls.size()),
                          0) +
                    " %";
    }
    return text.empty() ? kNothing : text;
}

/// "1.00 (7 of 10)"; "0.50 (10), 1.00 (40 of 50)" where walls have limits of their modes.
std::string limits_text(const std::vector<fragility::Cap>& limits, std::size_t walls,
                        int decimals)
{
    std::string text;
    for (const fragility::Cap& limit : limits)
        text += (text.empty() ? "" : ", ") + fixed(limit.value, decimals) + " (" +
                number(limit.walls, 12) +
                (&limit == &limits.back() ? " of " + std::to_string(walls) : "") + ")";
    return text;
}

/// The median drift of the observed shares with its interval, as the tables have it; "> 2.7" where fewer than half of
/// the walls got there. A drift limit of a code is no estimate: the walls that have it are counted.
std::string median_of(const DriftData& data, const DriftGroup& group, std::size_t state)
{
    constexpr int kDecimals = 2;
    constexpr std::array kHalf = {0.5};
    const auto observed = limits_of(group, state);
    if (observed.empty()) return kNothing;
    const auto median =
        fragility::observed_quantiles(observed, kHalf, data.options.confidence).front();
    if (!median.value)
        return "> " +
               fixed(std::floor(100.0 * fragility::common_end(observed)) / 100.0, kDecimals);
    const auto limits = fragility::caps(observed);
    if (only_limits(observed) ||
        std::ranges::find(limits, *median.value, &fragility::Cap::value) != limits.end())
        return limits_text(limits, observed.size(), kDecimals);
    return fixed(*median.value, kDecimals) +
           interval(median.interval.lower, median.interval.upper, kDecimals);
}

/// The severest limit states of each set first: SLC before SLO.
std::vector<std::size_t> severest_first(const DriftData& data)
{
    std::vector<std::size_t> order;
    for (std::size_t begin = 0; begin < data.states.size();) {
        std::size_t end = begin;
        while (end < data.states.size() && data.states[end].set == data.states[begin].set)
            ++end;
        for (std::size_t s = end; s-- > begin;) order.push_back(s);
        begin = end;
    }
    // what an engineer looks for: a code's limits before the paper's
    std::ranges::stable_sort(order, {}, [&](std::size_t s) {
        return data.states[s].set == "paper" || data.states[s].set == "collapse";
    });
    return order;
}

std::vector<std::size_t> shown_levels(std::size_t n)
{
    std::vector<std::size_t> shown;
    const std::size_t most = std::min(n, kMostAnswers);
    for (std::size_t i = 0; i < most; ++i)
        shown.push_back(most == 1 ? 0 : i * (n - 1) / (most - 1));
    return shown;
}

} // namespace

Json answers_json(const StudyWalls& study, const DriftData& data)
{
    const std::vector<std::size_t> states = severest_first(data);
    const double confidence = data.options.confidence;
    const std::string drift = data.unit.empty() ? "" : " [" + data.unit + "]";
    Json head = {"stress", "peak force [kN]"};
    for (const std::size_t s : states) head.push_back(state_name(data.states[s]) + drift);
    head.push_back("how it failed");
    Json rows = Json::array();
    const std::vector<std::size_t> levels = shown_levels(study.levels.size());
    for (const std::size_t l : levels) {
        const StudyLevel& level = study.levels[l];
        Json row = {stress_text(level.stress), peak_of(level, confidence)};
        for (const std::size_t s : states)
            row.push_back(l < data.groups.size() ? median_of(data, data.groups[l], s)
                                                 : std::string(kNothing));
        row.push_back(modes_of_level(level));
        rows.push_back(row);
    }
    std::string note =
        "Limit states: the drift that half of the walls have reached, [" +
        number(100.0 * confidence, 4) +
        " % interval]. \"> 2.7\": fewer than half have reached it. \"(7 of "
        "10)\": 7 of 10 walls have "
        "a drift limit that is set, by a code or by the user. …: no upper bound.";
    if (levels.size() < study.levels.size())
        note += " " + std::to_string(levels.size()) + " of " +
                std::to_string(study.levels.size()) +
                " stresses; the sections below have all of them.";
    return {{"head", head}, {"rows", rows}, {"note", note}};
}

} // namespace app
