#include "fragility/limits/possible_laws.hpp"

#include "core/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fragility {
namespace {

constexpr std::array kPositiveLaws = {Law::lognormal, Law::weibull, Law::gamma};
constexpr double kLeastLikely = 0.75; // of the largest likelihood

/// Sum over the modes; -infinity where the law cannot be that of walls whose own law can.
double log_likelihood(std::span<const ModeGroup> modes, Law law)
{
    double sum = 0.0;
    for (const ModeGroup& m : modes) {
        const Fit f = fit(law, m.limits);
        if (f.outcome == FitOutcome::not_positive) return -core::kInfinity;
        if (!m.described || fit(m.law, m.limits).outcome != FitOutcome::converged) continue;
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
    std::array<double, kPositiveLaws.size()> likely{};
    std::ranges::transform(kPositiveLaws, likely.begin(),
                           [&](Law law) { return log_likelihood(modes, law); });
    const double best = std::max(std::ranges::max(likely), log_likelihood(modes, own));
    const double least = best + std::log(kLeastLikely);
    std::vector<Law> others;
    for (std::size_t i = 0; i < likely.size(); ++i)
        if (kPositiveLaws[i] != own && likely[i] >= least) others.push_back(kPositiveLaws[i]);
    return others;
}

} // namespace fragility
