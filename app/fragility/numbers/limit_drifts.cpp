#include "app/fragility/numbers/limit_drifts.hpp"

#include "app/output/table/cells.hpp"
#include "core/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace app {
namespace {

using fragility::LimitQuantiles;
using fragility::QuantileSource;

/// Walls of each mode, or all of them where modes are not known.
/// @param end of the errors of inaccurate walls; nothing: the drifts as computed
fragility::QuantileData quantile_data(const DriftData& data, std::size_t group,
                                      std::size_t state, std::optional<ErrorEnd> end)
{
    const DriftGroup& g = data.groups[group];
    fragility::QuantileData walls;
    const int last = static_cast<int>(data.modes.size());
    for (int m = last > 0 ? 0 : -1; m < last; ++m) {
        auto limits = end ? limits_at(g, state, *end, m) : limits_of(g, state, m);
        if (limits.empty()) continue;
        const bool described = !rejected(judged_fit(data, group, state, m));
        walls.modes.push_back({std::move(limits), data.options.law, described});
    }
    walls.described = !rejected(judged_fit(data, group, state));
    return walls;
}

void widen(core::Interval& interval, const core::Interval& other)
{
    interval.lower = std::min(interval.lower, other.lower);
    interval.upper = std::max(interval.upper, other.upper);
}

/// The law of all walls, with intervals that hold at both ends of the errors.
fragility::PerformanceLimits law_of(const DriftData& data, const DriftGroup& group,
                                    std::size_t state)
{
    const auto by_law = [&](const std::vector<fragility::Observation>& walls) {
        return fragility::performance_limits(data.options.law, walls, data.options.confidence);
    };
    constexpr double kNone = core::kInfinity;
    fragility::PerformanceLimits law = by_law(limits_of(group, state));
    if (inaccurate_walls(group, state) == 0) return law;
    for (const ErrorEnd end : {ErrorEnd::least, ErrorEnd::most}) {
        const fragility::PerformanceLimits other = by_law(limits_at(group, state, end));
        if (end == ErrorEnd::least) law.bound = other.bound;
        if (!law.fitted) continue;
        const core::Interval open{0.0, kNone, data.options.confidence};
        for (std::size_t i = 0; i < law.drifts.size(); ++i)
            widen(law.drifts[i].interval, other.fitted ? other.drifts[i].interval : open);
        widen(law.dispersion_interval, other.fitted ? other.dispersion_interval : open);
    }
    return law;
}

/// A quantile that is a lower bound at one end of the errors is one.
void widen(LimitQuantiles& quantiles, const LimitQuantiles& other)
{
    for (std::size_t i = 0; i < quantiles.at.size() && i < other.at.size(); ++i) {
        widen(quantiles.at[i].interval, other.at[i].interval);
        if (!other.at[i].value) quantiles.at[i].interval.upper = core::kInfinity;
    }
}

} // namespace

LimitDrifts limit_drifts(const DriftData& data, std::size_t group, std::size_t state)
{
    const DriftGroup& g = data.groups[group];
    if (!g.limits.empty()) return g.limits[state];
    LimitDrifts found{{}, law_of(data, g, state), judged_fit(data, group, state)};
    const double confidence = data.options.confidence;
    found.quantiles = fragility::limit_quantiles(quantile_data(data, group, state, {}),
                                                 found.law, confidence);
    if (inaccurate_walls(g, state) == 0) return found;
    for (const ErrorEnd end : {ErrorEnd::least, ErrorEnd::most}) {
        const auto law = fragility::performance_limits(data.options.law,
                                                       limits_at(g, state, end), confidence);
        widen(found.quantiles, fragility::limit_quantiles(
                                   quantile_data(data, group, state, end), law, confidence));
    }
    return found;
}

void choose_limits(DriftData& data, const FitProgress& seen)
{
    judge(data, seen);
    for (std::size_t g = 0; g < data.groups.size(); ++g) {
        std::vector<LimitDrifts> limits;
        for (std::size_t s = 0; s < data.states.size(); ++s)
            limits.push_back(limit_drifts(data, g, s));
        data.groups[g].limits = std::move(limits);
    }
}

bool identified(const LimitDrifts& limits)
{
    return limits.law.fitted || fragility::is_mixture(limits.quantiles.source);
}

std::string not_identified_text(const LimitDrifts& limits, const DriftGroup& group)
{
    const fragility::PerformanceLimits& law = limits.law;
    if (law.n > 0.0 && law.censored_share == 1.0)
        return "Not identifiable: no wall reached it.";
    if (law.n > 0.0) {
        constexpr std::string_view opening = "not identifiable: ";
        const bool opened = law.reason.starts_with(opening);
        return "Not identifiable: " + law.reason.substr(opened ? opening.size() : 0) + ".";
    }
    return group.walls.empty() ? "No wall gave a result."
                               : "The limit state is not defined on any curve.";
}

Number quantile_cell(const fragility::LimitQuantile& q, int decimals)
{
    if (q.value) return with_interval(*q.value, q.interval, decimals);
    if (!(q.interval.lower > 0.0)) return {};
    return {.lower = q.interval.lower, .decimals = decimals, .sense = Sense::above};
}

std::string source_text(const LimitQuantiles& quantiles)
{
    if (quantiles.at.empty()) return {};
    switch (quantiles.source) {
    case QuantileSource::mixture:
        return "mixture";
    case QuantileSource::heaps:
        return "two heaps";
    case QuantileSource::observed:
        return "observed";
    case QuantileSource::law:
        return std::ranges::any_of(quantiles.at, &fragility::LimitQuantile::observed)
                   ? "law, observed"
                   : "law";
    case QuantileSource::none:
        break;
    }
    return {};
}

std::string source_note(const LimitDrifts& limits)
{
    switch (limits.quantiles.source) {
    case fragility::QuantileSource::mixture:
        return "The drifts add the curves of the modes, weighted by their shares.";
    case fragility::QuantileSource::heaps:
        return "The drifts lie in two heaps that are apart, each with a law of its own.";
    case fragility::QuantileSource::observed:
        return rejected_text(limits.judged);
    case fragility::QuantileSource::law:
        if (std::ranges::any_of(limits.quantiles.at, &fragility::LimitQuantile::observed))
            return "Walls stood when their push ended: shares above half of those reached are "
                   "the observed ones (Kaplan-Meier), since what stands may be another heap.";
        break;
    case fragility::QuantileSource::none:
        break;
    }
    return {};
}

bool of_one_law(const LimitQuantiles& quantiles)
{
    return quantiles.source == QuantileSource::law &&
           std::ranges::none_of(quantiles.at, &fragility::LimitQuantile::observed);
}

std::optional<double> dispersion_of(const LimitDrifts& limits)
{
    if (limits.quantiles.source == QuantileSource::law) return limits.law.dispersion;
    if (!fragility::is_mixture(limits.quantiles.source)) return {};
    const auto& low = limits.quantiles.at[1].value;
    const auto& high = limits.quantiles.at[3].value;
    if (!low || !high || !(*low > 0.0)) return {};
    constexpr double kDeviates = 2.0 * 0.994457883209753; // of 16 and 84 %
    return std::log(*high / *low) / kDeviates;
}

} // namespace app
