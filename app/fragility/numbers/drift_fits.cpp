#include "app/fragility/numbers/drift_fits.hpp"

#include "app/text/number_text.hpp"
#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cstdint>

namespace app {
namespace {

bool same(const std::vector<fragility::Observation>& a,
          const std::vector<fragility::Observation>& b)
{
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) {
        return x.lower == y.lower && x.upper == y.upper && x.weight == y.weight &&
               x.capped == y.capped;
    });
}

/// Place among the fits of a group.
std::size_t place(const DriftData& data, std::size_t state, int mode)
{
    return state * (data.modes.size() + 1) + static_cast<std::size_t>(mode + 1);
}

} // namespace

JudgedFit judged(const DriftOptions& options, fragility::Law law,
                 std::span<const fragility::Observation> limits, std::size_t group,
                 const std::function<void(double)>& seen)
{
    JudgedFit f{fragility::fit(law, limits), {}};
    const std::uint64_t seed = uq::replicate_seed(options.seed, group);
    const auto bits = [seed](std::uint64_t replicate, std::uint64_t draw) {
        return uq::bits(seed, replicate, uq::Purpose::bootstrap, draw);
    };
    if (options.bootstrap > 0)
        f.tests = fragility::goodness_of_fit(f.fit, limits, bits, options.bootstrap, seen);
    return f;
}

void judge(DriftData& data, const FitProgress& progress)
{
    const std::size_t of_group = data.states.size() * (data.modes.size() + 1);
    const auto all = static_cast<double>(data.groups.size() * of_group);
    for (std::size_t g = 0; g < data.groups.size(); ++g) {
        DriftGroup& group = data.groups[g];
        std::vector<std::vector<fragility::Observation>> seen; // many sets share a limit state
        std::vector<JudgedFit> fits;
        for (std::size_t s = 0; s < data.states.size(); ++s)
            for (int m = -1; m < static_cast<int>(data.modes.size()); ++m) {
                seen.push_back(limits_of(group, s, m));
                const auto known = std::ranges::find_if(
                    seen, [&](const auto& x) { return same(x, seen.back()); });
                const auto i = static_cast<std::size_t>(known - seen.begin());
                const auto before = static_cast<double>(g * of_group + fits.size());
                const auto tell = [&](double done) {
                    if (progress)
                        progress((before + done) / all,
                                 group.name + ", " + state_name(data.states[s]));
                };
                fits.push_back(i + 1 < seen.size() ? JudgedFit(fits[i])
                                                   : judged(data.options, data.options.law,
                                                            seen.back(), g, tell));
            }
        group.fits = std::move(fits);
    }
}

JudgedFit judged_fit(const DriftData& data, std::size_t group, std::size_t state, int mode)
{
    const DriftGroup& g = data.groups[group];
    if (!g.fits.empty()) return g.fits[place(data, state, mode)];
    return judged(data.options, data.options.law, limits_of(g, state, mode), group);
}

JudgedFit judged_lognormal(const DriftData& data, std::size_t group, std::size_t state)
{
    constexpr fragility::Law law = fragility::Law::lognormal;
    return data.options.law == law
               ? judged_fit(data, group, state)
               : judged(data.options, law, limits_of(data.groups[group], state), group);
}

bool rejected(const JudgedFit& f) { return fragility::least_p(f.tests) < fragility::kRejected; }

bool describes(const JudgedFit& f)
{
    return f.fit.outcome == fragility::FitOutcome::converged && !rejected(f);
}

std::string rejected_text(const JudgedFit& f)
{
    return "The fitted curve does not describe the walls (p = " +
           number(fragility::least_p(f.tests), 2) +
           "); the row shows the observed percentages instead (Kaplan-Meier).";
}

} // namespace app
