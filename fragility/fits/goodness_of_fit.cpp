#include "fragility/fits/goodness_of_fit.hpp"

#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/fits/resampling.hpp"
#include "fragility/fits/two_heaps.hpp"

#include <algorithm>
#include <cmath>

namespace fragility {
namespace {

/// Where the fitted distribution is at a value: F and 1 - F, each with all its digits.
struct Fitted {
    double below, above;
};

double times_log(double factor, double x) { return factor == 0.0 ? 0.0 : factor * std::log(x); }

/// Adds what lies between two values, where the empirical share is constant:
///   int (a - z)^2 dz,   int (a - z)^2 / (z (1 - z)) dz
void add_between(Distances& d, double share, const Fitted& from, const Fitted& to)
{
    d.kolmogorov_smirnov = std::max(
        {d.kolmogorov_smirnov, std::abs(share - from.below), std::abs(share - to.below)});
    d.cramer_von_mises +=
        (std::pow(to.below - share, 3) - std::pow(from.below - share, 3)) / 3.0;
    const auto whole = [&](const Fitted& z) {
        return times_log(share * share, z.below) -
               times_log((1.0 - share) * (1.0 - share), z.above) - z.below;
    };
    d.anderson_darling += whole(to) - whole(from);
}

bool can_be_judged(std::span<const Observation> data, bool positive)
{
    bool any = false;
    for (const Observation& o : data) {
        const Censoring kind = censoring(o, positive);
        if (o.weight != 1.0 || kind == Censoring::left || kind == Censoring::interval)
            return false;
        any = any || kind == Censoring::none;
    }
    return any;
}

} // namespace

std::optional<Distances> distances(const Distribution& law, std::span<const Observation> data)
{
    if (!can_be_judged(data, positive(law.law))) return std::nullopt;
    const KaplanMeier km = kaplan_meier(data);
    const auto fitted = [&](double x) { return Fitted{cdf(law, x), survival(law, x)}; };
    Distances d;
    Fitted from{0.0, 1.0};
    double share = 0.0;
    for (const KaplanMeierStep& step : km.steps) {
        const Fitted to = fitted(step.at);
        add_between(d, share, from, to);
        from = to;
        share = step.probability;
    }
    add_between(d, share, from, share < 1.0 ? fitted(km.end) : Fitted{1.0, 0.0});
    const double n = static_cast<double>(data.size());
    d.cramer_von_mises *= n;
    d.anderson_darling *= n;
    d.two_heaps = two_heaps(data, positive(law.law));
    return d;
}

double least_p(const GoodnessOfFit& tests)
{
    if (!tests.available) return 1.0;
    return std::min({tests.p_kolmogorov_smirnov, tests.p_cramer_von_mises,
                     tests.p_anderson_darling, tests.p_two_heaps});
}

GoodnessOfFit goodness_of_fit(const Fit& f, std::span<const Observation> data,
                              const RandomBits& bits, std::size_t replicates,
                              const std::function<void(double)>& seen)
{
    GoodnessOfFit g;
    if (f.outcome != FitOutcome::converged) {
        g.reason = "no fit: " + f.reason;
        return g;
    }
    const auto found = distances(f.law, data);
    if (!found) {
        g.reason = "only for values that are observed or right-censored";
        return g;
    }
    g.distance = *found;
    const StoppingPoints stops(data);
    replicates = std::min(replicates, std::max(kFewestReplicates, kMostDraws / data.size()));
    double further[4] = {1.0, 1.0, 1.0, 1.0};
    for (std::size_t r = 0; r < replicates; ++r) {
        if (seen) seen(static_cast<double>(r) / static_cast<double>(replicates));
        const auto sample = draw_law(f.law, stops, data.size(), bits, r);
        const Fit refit = fit(f.law.law, sample);
        const auto d = refit.outcome == FitOutcome::converged ? distances(refit.law, sample)
                                                              : std::nullopt;
        if (!d) {
            ++g.failed;
            continue;
        }
        ++g.replicates;
        further[0] += d->kolmogorov_smirnov >= found->kolmogorov_smirnov;
        further[1] += d->cramer_von_mises >= found->cramer_von_mises;
        further[2] += d->anderson_darling >= found->anderson_darling;
        further[3] += d->two_heaps >= found->two_heaps;
    }
    const double n = static_cast<double>(g.replicates) + 1.0;
    g.available = g.replicates > 0;
    if (!g.available) g.reason = "no resample could be fitted";
    g.p_kolmogorov_smirnov = further[0] / n;
    g.p_cramer_von_mises = further[1] / n;
    g.p_anderson_darling = further[2] / n;
    g.p_two_heaps = found->two_heaps > 0.0 ? further[3] / n : 1.0;
    return g;
}

} // namespace fragility
