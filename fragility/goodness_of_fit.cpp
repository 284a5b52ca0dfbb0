#include "fragility/goodness_of_fit.hpp"

#include "fragility/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fragility {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Ordered {
    std::vector<double> values; ///< observed, ascending
    double n = 0.0;             ///< of all
    double limit = kInfinity;   ///< common right-censoring value
};

std::optional<Ordered> ordered(std::span<const Observation> data, bool positive)
{
    Ordered x;
    x.n = static_cast<double>(data.size());
    for (const Observation& o : data) {
        const Censoring kind = censoring(o, positive);
        if (o.weight != 1.0 || kind == Censoring::left || kind == Censoring::interval)
            return std::nullopt;
        if (kind == Censoring::none) {
            x.values.push_back(o.lower);
        } else {
            if (x.limit < kInfinity && x.limit != o.lower) return std::nullopt;
            x.limit = o.lower;
        }
    }
    std::ranges::sort(x.values);
    if (x.values.empty() || x.values.back() > x.limit) return std::nullopt;
    return x;
}

} // namespace

std::optional<Distances> distances(const Distribution& law, std::span<const Observation> data)
{
    const auto x = ordered(data, positive(law.law));
    if (!x) return std::nullopt;
    const double n = x->n;
    const double r = static_cast<double>(x->values.size());
    const double t = x->limit < kInfinity ? cdf(law, x->limit) : 1.0;
    Distances d;
    double logs = 0.0;
    for (std::size_t i = 0; i < x->values.size(); ++i) {
        const double k = static_cast<double>(i); // values below
        const double z = cdf(law, x->values[i]);
        const double above = survival(law, x->values[i]);
        d.kolmogorov_smirnov =
            std::max(d.kolmogorov_smirnov, std::max((k + 1.0) / n - z, z - k / n));
        d.cramer_von_mises += std::pow(z - (k + 0.5) / n, 2);
        logs += (2.0 * k + 1.0) * (std::log(z) - std::log(above)) + 2.0 * n * std::log(above);
    }
    d.cramer_von_mises += r / (12.0 * n * n);
    d.anderson_darling = -logs / n;
    if (r == n) {
        d.anderson_darling -= n;
        return d;
    }
    const double rest = x->limit < kInfinity ? survival(law, x->limit) : 0.0;
    d.kolmogorov_smirnov = std::max(d.kolmogorov_smirnov, std::abs(t - r / n));
    d.cramer_von_mises += n / 3.0 * std::pow(t - r / n, 3);
    d.anderson_darling -=
        ((r - n) * (r - n) * std::log(rest) - r * r * std::log(t) + n * n * t) / n;
    return d;
}

GoodnessOfFit goodness_of_fit(const Fit& f, std::span<const Observation> data,
                              const RandomBits& bits, std::size_t replicates)
{
    GoodnessOfFit g;
    if (f.outcome != FitOutcome::converged) {
        g.reason = "no fit: " + f.reason;
        return g;
    }
    const auto found = distances(f.law, data);
    if (!found) {
        g.reason = "only for observed values, right-censored at most at one common value";
        return g;
    }
    g.distance = *found;
    const StoppingPoints stops(data);
    double further[3] = {1.0, 1.0, 1.0};
    for (std::size_t r = 0; r < replicates; ++r) {
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
    }
    const double n = static_cast<double>(g.replicates) + 1.0;
    g.available = g.replicates > 0;
    if (!g.available) g.reason = "no resample could be fitted";
    g.p_kolmogorov_smirnov = further[0] / n;
    g.p_cramer_von_mises = further[1] / n;
    g.p_anderson_darling = further[2] / n;
    return g;
}

} // namespace fragility
