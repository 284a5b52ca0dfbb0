#include "fragility/limits/possible_laws.hpp"

#include "core/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fragility {
namespace {

constexpr std::array kPositiveLaws = {Law::lognormal, Law::weibull, Law::gamma};
constexpr double kLeastLikely = 0.75; // of the largest likelihood

/// Sum over the modes; -infinity where the law cannot be that of all of them.
/// @param counts whether a mode is described by its own law
double log_likelihood(std::span<const ModeGroup> modes, const std::vector<bool>& counts,
                      Law law)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < modes.size(); ++k) {
        const Fit f = fit(law, modes[k].limits);
        if (f.outcome == FitOutcome::not_positive) return -core::kInfinity;
        if (!counts[k]) continue;
        if (f.outcome != FitOutcome::converged) return -core::kInfinity;
        sum += f.log_likelihood;
    }
    return sum;
}

} // namespace

std::vector<Law> other_possible_laws(std::span<const ModeGroup> modes)
{
    if (modes.empty()) return {};
    const Law own = modes.front().law;
    std::vector<bool> counts;
    double best = 0.0;
    for (const ModeGroup& m : modes) {
        const Fit f = fit(own, m.limits);
        counts.push_back(m.described && f.outcome == FitOutcome::converged);
        if (counts.back()) best += f.log_likelihood;
    }
    std::array<double, kPositiveLaws.size()> likely{};
    std::ranges::transform(kPositiveLaws, likely.begin(),
                           [&](Law law) { return log_likelihood(modes, counts, law); });
    best = std::max(best, std::ranges::max(likely));
    const double least = best + std::log(kLeastLikely);
    std::vector<Law> others;
    for (std::size_t i = 0; i < likely.size(); ++i)
        if (kPositiveLaws[i] != own && likely[i] >= least) others.push_back(kPositiveLaws[i]);
    return others;
}

} // namespace fragility
