#include "app/fragility/numbers/answer_table.hpp"

#include "app/fragility/numbers/limit_drifts.hpp"
#include "app/fragility/numbers/model_doubt.hpp"
#include "app/fragility/numbers/table_texts.hpp"
#include "app/output/table/cells.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace app {
namespace {

using fragility::QuantileBounds;

constexpr int kDriftDecimals = 2;

Number mean_peak(const StudyLevel& level, double confidence)
{
    std::vector<double> peaks;
    for (const StudyWall& w : level.walls)
        if (w.reading.peak) peaks.push_back(w.reading.peak->force * 1e-3);
    if (peaks.empty()) return {};
    if (peaks.size() == 1) return plain_number(peaks.front(), 1);
    const uq::Estimate e = uq::estimate_mean(peaks, confidence);
    return with_interval(e.value, e.interval, 1);
}

/// "rocking 76 %, mixed 24 %": the largest share first.
std::string modes_of_level(const StudyLevel& level)
{
    std::array<std::size_t, kAllModes> n{};
    for (const StudyWall& w : level.walls) ++n.at(static_cast<std::size_t>(mode_of(w)));
    std::array<int, kAllModes> order{kRocking, kSliding, kMixed};
    const auto walls = [&](int mode) { return n.at(static_cast<std::size_t>(mode)); };
    std::ranges::stable_sort(order, [&](int a, int b) { return walls(a) > walls(b); });
    std::string text;
    for (const int mode : order) {
        if (walls(mode) == 0) continue;
        text += (text.empty() ? "" : ", ") + std::string(mode_name(mode));
        if (walls(mode) < level.walls.size())
            text += " " +
                    fixed(100.0 * static_cast<double>(walls(mode)) /
                              static_cast<double>(level.walls.size()),
                          0) +
                    " %";
    }
    return text;
}

/// The severest limit state of each set; a code's before the paper's.
std::vector<std::size_t> severest_states(const DriftData& data)
{
    std::vector<std::size_t> found;
    for (std::size_t s = 0; s < data.states.size(); ++s)
        if (s + 1 == data.states.size() || data.states[s + 1].set != data.states[s].set)
            found.push_back(s);
    std::ranges::stable_sort(found, {}, [&](std::size_t s) {
        return data.states[s].set == "paper" || data.states[s].set == "collapse";
    });
    return found;
}

/// "> 2.72", rounded down; 2.72 itself stays.
std::string above(double x)
{
    return "> " + fixed(std::floor(100.0 * x + 1e-6) / 100.0, kDriftDecimals);
}

bool is_known(const QuantileBounds& q) { return std::isfinite(q.upper) && q.lower > 0.0; }

/// "2.45"; "2.40–2.51" where it depends on what lies beyond the drift tested; "> 2.72" where
/// that is all there is to say.
std::string drift_of(const QuantileBounds& q)
{
    if (!is_known(q)) return q.lower > 0.0 ? above(q.lower) : "?";
    const std::string low = fixed(q.lower, kDriftDecimals),
                      high = fixed(q.upper, kDriftDecimals);
    return low == high ? low : low + "–" + high;
}

/// "2.45 (1.60 to 3.91)"; "> 2.72 (16 %: 1.60)" where the median lies beyond the drift tested.
std::string doubted_text(const fragility::DoubtedLimit& limit)
{
    const auto& [low, median, high] = limit.quantiles;
    if (is_known(median))
        return drift_of(median) + " (" + drift_of(low) + " to " + drift_of(high) + ")";
    return drift_of(median) + (is_known(low) ? " (16 %: " + drift_of(low) + ")" : "");
}

/// Where no law can be fitted to the walls: the bound of their median, or that they are too
/// few for one and the drifts of all of them: "too few walls: 0.35 to 0.61", "0.35 and more"
/// where a wall stood.
/// @param factor of the model, its median
std::string bound_text(const fragility::MedianBound& bound,
                       const std::vector<fragility::Observation>& walls, double factor)
{
    if (bound.median_bounded) return above(bound.median_above);
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const fragility::Observation& w : walls) {
        least = std::min(least, w.lower);
        most = std::max(most, w.upper);
    }
    const std::string words = "too few walls: ", low = fixed(factor * least, kDriftDecimals);
    if (std::isinf(most)) return words + low + " and more";
    const std::string high = fixed(factor * most, kDriftDecimals);
    return words + low + (high == low ? "" : " to " + high);
}

std::string drift_text(const DriftData& data, std::size_t group, std::size_t state)
{
    constexpr std::size_t kMedian = 2;
    const auto observed = limits_of(data.groups[group], state);
    if (observed.empty()) return {};
    if (const auto limit = doubted_limit(data, group, state)) return doubted_text(*limit);
    const std::string cap = limit_text(data, group, state),
                      pier = pier_text(data, group, state);
    const auto caps = fragility::caps(observed);
    const LimitDrifts limits = limit_drifts(data, group, state);
    const auto& drifts = limits.quantiles.at;
    std::string median;
    if (drifts.empty() || (cap.empty() && !identified(limits)))
        median = bound_text(limits.law.bound, observed,
                            pier.empty() ? data.groups[group].model.factor.median : 1.0);
    else if (!drifts[kMedian].value)
        median = above(drifts[kMedian].interval.lower);
    else if (std::ranges::count(caps, *drifts[kMedian].value, &fragility::Cap::value) == 0)
        median = fixed(*drifts[kMedian].value, kDriftDecimals);
    if (!pier.empty()) median += " (" + pier + ")";
    return median + (median.empty() || cap.empty() ? "" : "; ") + cap;
}

/// "factor 1.8 either way: model 0.40, material 0.45"; empty where the walls do not tell.
std::string factor_phrase(const fragility::Dispersions& d)
{
    if (!std::isfinite(d.total) || !(d.total > 0.0)) return {};
    std::string parts;
    for (const auto& [name, x] :
         {std::pair{"model", d.model}, {"material", d.material}, {"sampling", d.sampling}})
        if (x >= 0.005)
            parts += (parts.empty() ? "" : ", ") + std::string(name) + " " + fixed(x, 2);
    return "factor " + fixed(std::exp(d.total), 1) + " either way" +
           (parts.empty() ? "" : ": " + parts);
}

/// Facts that an engineer has to know before the numbers are used, of the first state that is
/// the walls' own.
std::string sure_text(const DriftData& data, std::size_t g,
                      const std::vector<std::size_t>& states)
{
    constexpr std::size_t kFew = 20;
    const DriftGroup& group = data.groups[g];
    std::vector<std::string> facts;
    const std::size_t n = group.walls.size();
    if (n < kFew) facts.push_back("only " + counted(n, "wall", "walls"));
    std::optional<fragility::DoubtedLimit> limit;
    std::optional<std::size_t> state;
    for (const std::size_t s : states) {
        if (limit) break;
        limit = doubted_limit(data, g, s);
        if (limit || !state) state = s;
    }
    if (state) {
        const auto walls = limits_of(group, *state);
        const auto stood = std::ranges::count_if(
            walls, [](const fragility::Observation& o) { return std::isinf(o.upper); });
        if (stood > 0)
            facts.push_back(std::to_string(stood) + " of " +
                            counted(walls.size(), "wall", "walls") +
                            " stood to the end of the push");
        if (limit) facts.push_back(factor_phrase(limit->dispersion));
        if (const std::size_t bad = inaccurate_walls(group, *state); bad > 0)
            facts.push_back(counted(bad, "wall misses", "walls miss") + " the accuracy");
    }
    if (group.failed > 0) facts.push_back(counted(group.failed, "wall", "walls") + " failed");
    if (group.missing > 0)
        facts.push_back(counted(group.missing, "wall", "walls") + " not run");
    std::string text;
    for (const std::string& fact : facts)
        if (!fact.empty()) text += (text.empty() ? "" : "; ") + fact;
    return text;
}

} // namespace

Table answer_table(const StudyWalls& walls, const DriftData& data)
{
    const std::vector<std::size_t> states = severest_states(data);
    Table t = titled_table("answer", words_of(data));
    if (!walls.piers.empty())
        t.caption +=
            " In brackets, piers whose drift limit comes first, and in how many walls.";
    t.head = {"stress [MPa]", number_head(wall_number("peak_force"), kInterval),
              "how it fails"};
    for (const std::size_t s : states)
        t.head.emplace_back(drift_head(data, state_name(data.states[s]) + " drift"));
    t.head.emplace_back("how sure");
    for (std::size_t l = 0; l < walls.levels.size(); ++l) {
        const StudyLevel& level = walls.levels[l];
        Row row = {stress_cell(level.stress), mean_peak(level, data.options.confidence),
                   modes_of_level(level)};
        const bool known = l < data.groups.size();
        for (const std::size_t s : states)
            row.emplace_back(known ? drift_text(data, l, s) : std::string());
        row.emplace_back(known ? sure_text(data, l, states) : std::string());
        t.rows.push_back(std::move(row));
    }
    return t;
}

} // namespace app
