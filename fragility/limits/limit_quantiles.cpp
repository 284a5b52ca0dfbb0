#include "fragility/limits/limit_quantiles.hpp"

#include "fragility/fits/observed_quantile.hpp"
#include "fragility/fits/two_heaps.hpp"
#include "fragility/limits/possible_laws.hpp"

#include <algorithm>
#include <cmath>

namespace fragility {
namespace {

/// Walls that stood when their push ended, for one that is still pushed.
constexpr double kEndedPerPushed = 5.0;

/// Share of those reached up to which a law of censored walls is read.
constexpr double kReadOfReached = 0.5;

bool stands(const Observation& o) { return o.upper == core::kInfinity; }

std::vector<Observation> all_walls(const std::vector<ModeGroup>& modes)
{
    std::vector<Observation> all;
    for (const ModeGroup& m : modes) all.insert(all.end(), m.limits.begin(), m.limits.end());
    return all;
}

/// Observed or standing, of weight 1: what Kaplan and Meier's shares need.
bool plain(const Observation& o)
{
    return o.weight == 1.0 && std::isfinite(o.lower) && (o.lower == o.upper || stands(o));
}

/// Cut where walls were no longer tested.
LimitQuantile cut(double share, double value, core::Interval interval, double end,
                  bool observed)
{
    const bool known = std::isfinite(value) && is_known(value, end);
    if (!is_known(interval.upper, end)) interval.upper = core::kInfinity;
    if (!known)
        interval = {std::min(interval.lower, end), core::kInfinity, interval.confidence};
    return {share, known ? std::optional(value) : std::nullopt, interval, observed};
}

std::vector<LimitQuantile> from_shares(std::span<const Observation> walls, double end,
                                       double confidence)
{
    std::vector<LimitQuantile> found;
    const auto seen = observed_quantiles(walls, kLimitShares, confidence);
    for (std::size_t i = 0; i < seen.size(); ++i)
        found.push_back(cut(kLimitShares[i], seen[i].value.value_or(core::kInfinity),
                            seen[i].interval, end, true));
    return found;
}

/// Widens an interval by the ends that another one gives: neither 0 nor infinite.
void hold(core::Interval& interval, const core::Interval& other)
{
    if (other.lower != 0.0) interval.lower = std::min(interval.lower, other.lower);
    if (std::isfinite(other.upper)) interval.upper = std::max(interval.upper, other.upper);
}

/// The ends that the band of a mixture does not give, from the ranks of all walls.
void mend(core::Interval& band, double value, const core::Interval& ranks)
{
    if (!(band.lower > 0.0)) band.lower = std::min(ranks.lower, value);
    if (!std::isfinite(band.upper)) band.upper = std::max(ranks.upper, value);
}

std::vector<LimitQuantile> from_mixture(const std::vector<ModeGroup>& modes, double end,
                                        double confidence)
{
    std::vector<LimitQuantile> found;
    auto mixture = mixture_quantiles(modes, kLimitShares, confidence);
    std::vector<ModeGroup> others = modes;
    for (const Law law : other_possible_laws(modes)) {
        for (ModeGroup& m : others) m.law = law;
        const auto other = mixture_quantiles(others, kLimitShares, confidence);
        for (std::size_t i = 0; i < mixture.size(); ++i)
            hold(mixture[i].interval, other[i].interval);
    }
    if (const auto walls = all_walls(modes); std::ranges::all_of(walls, plain)) {
        const auto seen = observed_quantiles(walls, kLimitShares, confidence);
        for (std::size_t i = 0; i < seen.size(); ++i)
            mend(mixture[i].interval, mixture[i].value, seen[i].interval);
    }
    for (std::size_t i = 0; i < mixture.size(); ++i)
        found.push_back(
            cut(kLimitShares[i], mixture[i].value, mixture[i].interval, end, false));
    return found;
}

/// Quantiles do not fall with the share: what bounds one from below bounds all larger ones, and
/// what bounds one from above bounds all smaller ones.
void never_fall(std::vector<LimitQuantile>& at)
{
    for (std::size_t i = 1; i < at.size(); ++i)
        at[i].interval.lower = std::max(at[i].interval.lower, at[i - 1].interval.lower);
    for (std::size_t i = at.size(); i-- > 1;)
        at[i - 1].interval.upper = std::min(at[i - 1].interval.upper, at[i].interval.upper);
}

/// The share reached at `end` as observed.
double reached_at(std::span<const Observation> walls, double end)
{
    if (!std::isfinite(end)) return 1.0;
    return observed_shares(walls, std::vector{end * (1.0 + kEndsTogether)}).front().share;
}

/// Quantiles of one law, and of the shares where the law is not to be trusted.
std::vector<LimitQuantile> from_law(const PerformanceLimits& limits, Law law,
                                    const std::vector<Observation>& walls, double end,
                                    double confidence)
{
    const bool shares_known = std::ranges::all_of(walls, plain);
    const double trusted =
        std::isfinite(end) && shares_known ? kReadOfReached * reached_at(walls, end) : 1.0;
    auto drifts = limits.drifts;
    for (const Law other : other_possible_laws(std::vector<ModeGroup>{{walls, law, true}})) {
        const PerformanceLimits by_other = performance_limits(other, walls, confidence);
        for (std::size_t i = 0; i < drifts.size(); ++i)
            hold(drifts[i].interval, by_other.drifts[i].interval);
    }
    std::vector<LimitQuantile> found = shares_known ? from_shares(walls, end, confidence)
                                                    : std::vector<LimitQuantile>(drifts.size());
    for (std::size_t i = 0; i < drifts.size(); ++i)
        if (drifts[i].share <= trusted)
            found[i] = cut(drifts[i].share, drifts[i].drift, drifts[i].interval, end, false);
    return found;
}

/// Whether modes are more than a name for walls that stood: one of them has walls of both
/// kinds, or all walls fell.
bool tell_apart(const std::vector<ModeGroup>& modes)
{
    if (modes.size() < 2) return false;
    bool any_stands = false;
    for (const ModeGroup& m : modes) {
        const auto standing = static_cast<std::size_t>(std::ranges::count_if(m.limits, stands));
        if (standing > 0 && standing < m.limits.size()) return true;
        any_stands = any_stands || standing > 0;
    }
    return !any_stands;
}

/// Whether values part into two heaps that lie apart.
bool lie_apart(const Parting& p, double gain, double apart)
{
    return p.gain >= gain && p.apart >= apart;
}

/// The gain of a parting (two_heaps.hpp) from which heaps take the place of one law: of 50
/// walls of one law 1 in 25 studies has them. From half of it on the intervals of the law hold
/// those of the heaps, too. tuned: docs/bench/fragility/limit_coverage.md
constexpr double kSureGain = 8.0, kPossibleGain = 4.0;

/// Heaps of walls that all reached the limit state, where they lie apart: told by the drifts,
/// whatever modes the walls are said to have. Else nothing, also of three heaps.
/// @param gain kSureGain or kPossibleGain
std::vector<ModeGroup> heaps_apart(std::span<const Observation> walls, Law law, double gain)
{
    constexpr double kApart = 1.8; // tuned like the gains
    const auto none_of_it = [](const Observation& o) { return o.lower <= 0.0; };
    if (!std::ranges::all_of(walls, plain)) return {};
    if (positive(law) && std::ranges::any_of(walls, none_of_it)) return {};
    const Parting parting = best_parting(walls, positive(law));
    if (!lie_apart(parting, gain, kApart)) return {};
    std::vector<ModeGroup> heaps(2, {{}, law, true});
    for (const Observation& o : walls)
        heaps[o.lower > parting.last ? 1 : 0].limits.push_back(o);
    const bool three = std::ranges::any_of(heaps, [&](const ModeGroup& h) {
        return lie_apart(best_parting(h.limits, positive(law)), 2.0 * kSureGain, 2.5);
    });
    return three ? std::vector<ModeGroup>() : heaps;
}

bool has_law(const ModeGroup& m)
{
    return m.described && fit(m.law, m.limits).outcome == FitOutcome::converged;
}

/// Widens intervals of one law where a few walls may be a heap of their own, which no test of
/// the law sees.
void hold_possible_heaps(std::span<const Observation> walls, Law law, double confidence,
                         std::vector<LimitQuantile>& at)
{
    const auto heaps = heaps_apart(walls, law, kPossibleGain);
    if (std::ranges::none_of(heaps, has_law)) return;
    const auto other = from_mixture(heaps, core::kInfinity, confidence);
    for (std::size_t i = 0; i < at.size(); ++i) hold(at[i].interval, other[i].interval);
}

} // namespace

double tested_to(std::span<const Observation> walls)
{
    std::vector<Observation> sorted(walls.begin(), walls.end());
    std::ranges::sort(sorted, {}, &Observation::lower);
    double pushed = 0.0, ended = 0.0, end = 0.0;
    for (const Observation& o : sorted) pushed += o.weight;
    for (const Observation& o : sorted) {
        if (kEndedPerPushed * pushed >= ended) end = std::max(end, o.lower);
        pushed -= o.weight;
        if (stands(o)) ended += o.weight;
    }
    return ended > 0.0 || sorted.empty() ? end : core::kInfinity;
}

LimitQuantiles limit_quantiles(const QuantileData& data, const PerformanceLimits& law,
                               double confidence)
{
    LimitQuantiles found;
    const std::vector<Observation> walls = all_walls(data.modes);
    found.tested_to = tested_to(walls);
    std::vector<ModeGroup> modes = data.modes;
    std::erase_if(modes, [](const ModeGroup& m) { return m.limits.empty(); });
    const bool reached =
        std::ranges::any_of(walls, [](const Observation& o) { return !stands(o); });
    const bool own = std::ranges::none_of(walls, &Observation::capped);
    if (!reached || modes.empty()) return found;
    const bool well_told =
        tell_apart(modes) && std::ranges::all_of(modes, &ModeGroup::described);
    auto heaps = own && !well_told && !std::isfinite(found.tested_to)
                     ? heaps_apart(walls, modes.front().law, kSureGain)
                     : std::vector<ModeGroup>();
    if (std::ranges::any_of(heaps, has_law)) {
        found.source = QuantileSource::heaps;
        found.at = from_mixture(heaps, found.tested_to, confidence);
        found.heaps = std::move(heaps);
    } else if (own && tell_apart(modes) && std::ranges::any_of(modes, has_law)) {
        found.source = QuantileSource::mixture;
        found.at = from_mixture(modes, found.tested_to, confidence);
    } else if (own && law.fitted && data.described) {
        found.source = QuantileSource::law;
        found.at = from_law(law, modes.front().law, walls, found.tested_to, confidence);
        if (!std::isfinite(found.tested_to))
            hold_possible_heaps(walls, modes.front().law, confidence, found.at);
    } else if (std::ranges::all_of(walls, plain)) {
        found.source = QuantileSource::observed;
        found.at = from_shares(walls, found.tested_to, confidence);
    }
    never_fall(found.at);
    return found;
}

} // namespace fragility
