#include "app/study/study_stopping.hpp"

#include "app/reading/wall_numbers.hpp"
#include "app/text/number_text.hpp"
#include "fragility/fits/observed_quantile.hpp"
#include "uq/estimates/stopping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr std::size_t kLeastWalls = 2; ///< an interval takes two
/// Walls before the first look, at least. Choice: 95 % intervals of means of normal values at
/// which a study stops hold 88 % of the time where the first look is at 2, 92 % at 5, 94 % at
/// 10.
constexpr std::size_t kFirstLook = 10;
constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();

uq::StoppingRule rule_of(const UqInput& uq)
{
    uq::StoppingRule rule;
    const bool share = uq.stop == kStopAtMixedShare;
    rule.target = share ? uq::StoppingTarget::probability_below : uq::StoppingTarget::mean;
    rule.threshold = 0.5; // of 0: mixed, 1: rocking
    rule.relative = !share;
    rule.half_width = uq.stop_half_width;
    const auto samples = static_cast<std::size_t>(uq.samples);
    rule.max_n = std::max({kLeastWalls, samples, static_cast<std::size_t>(uq.most_samples)});
    rule.min_n = std::max({kLeastWalls, samples, std::min(kFirstLook, rule.max_n)});
    return rule;
}

/// Value of a wall that gave a result: of the response, or whether it failed in another mode
/// than mixed.
double value_of(const WallReading& wall, const LoadInput& load, const UqInput& uq)
{
    if (uq.stop == kStopAtMixedShare) return wall.mode == dem::FailureMode::mixed ? 0.0 : 1.0;
    return kWallNumbers.at(uq.stop).reading(wall, load.height);
}

/// A response that walls outlast is judged by its median of Kaplan and Meier: the mean of the
/// walls that the push was long enough for would be too small, and its interval too narrow.
bool stops_at_median(const UqInput& uq)
{
    return uq.stop != kStopAtMixedShare && kWallNumbers.at(uq.stop).ends_with_push;
}

std::optional<uq::Estimate> stopping_median(const StudyLevel& level, const LoadInput& load,
                                            const UqInput& uq, double confidence)
{
    const WallNumber& response = kWallNumbers.at(uq.stop);
    std::vector<fragility::Observation> walls;
    for (const StudyWall& w : level.walls)
        if (const double x = value_of(w.reading, load, uq); !std::isnan(x))
            walls.push_back(response.is_bound(w.reading) ? fragility::right_censored(x)
                                                         : fragility::observed(x));
    if (walls.empty()) return {};
    const auto m = fragility::observed_quantiles(walls, std::array{0.5}, confidence).front();
    if (!m.value) return {};
    return uq::Estimate{.value = *m.value,
                        .std_error = std::numeric_limits<double>::quiet_NaN(),
                        .n = walls.size(),
                        .failed = level.failed_walls.size(),
                        .interval = {m.interval.lower, m.interval.upper, confidence}};
}

uq::StoppingDecision stopping_decision(const StudyLevel& level, const LoadInput& load,
                                       const UqInput& uq, const uq::StoppingRule& rule)
{
    const std::size_t n = level.walls.size() + level.failed_walls.size();
    if (stops_at_median(uq))
        return uq::judge(rule, n, stopping_median(level, load, uq, rule.confidence));
    std::vector<double> values(level.failed_walls.size(), kFailed);
    for (const StudyWall& w : level.walls) values.push_back(value_of(w.reading, load, uq));
    return uq::judge(rule, values);
}

/// "54 walls, half width 0.0209 (wanted: 0.03), precise enough"
std::string stopping_words(const StudyLevel& level, const UqInput& uq,
                           const uq::StoppingRule& rule, const uq::StoppingDecision& d)
{
    std::string text =
        std::to_string(level.walls.size() + level.failed_walls.size()) + " walls, ";
    if (stops_at_median(uq)) {
        const WallNumber& response = kWallNumbers.at(uq.stop);
        const auto n = std::ranges::count_if(
            level.walls, [&](const StudyWall& w) { return response.is_bound(w.reading); });
        if (n > 0) text += std::to_string(n) + " of them outlast the push, ";
        text += "median: ";
    }
    text += std::isfinite(d.half_width) ? "half width " + number(d.half_width, 3)
                                        : "its interval has no limit";
    return text + " (wanted: " + number(rule.half_width, 3) + "), " +
           std::string(words(d.reason));
}

} // namespace

StoppingState stopping_state(const StudyWalls& walls)
{
    const uq::StoppingRule rule = rule_of(walls.study.uq);
    StoppingState state;
    for (const StudyLevel& level : walls.levels) {
        const uq::StoppingDecision d =
            stopping_decision(level, walls.study.load, walls.study.uq, rule);
        state.next = std::max(state.next, static_cast<std::uint32_t>(d.next_n));
        state.remark += stress_text(level.stress) + ": " +
                        stopping_words(level, walls.study.uq, rule, d) + "\n";
    }
    return state;
}

} // namespace app
