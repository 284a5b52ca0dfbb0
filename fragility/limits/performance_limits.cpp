#include "fragility/limits/performance_limits.hpp"

#include "fragility/laws/small_sample.hpp"

#include <cmath>

namespace fragility {

PerformanceLimits performance_limits(Law law, std::span<const Observation> data,
                                     double confidence)
{
    const Fit f = fit(law, data);
    PerformanceLimits row;
    row.reason = f.reason;
    row.n = f.counts.n;
    if (f.outcome == FitOutcome::invalid_value) return row;
    if (row.n > 0.0) row.censored_share = 1.0 - f.counts.observed / row.n;
    row.bound = median_bound(data, confidence);
    if (f.outcome != FitOutcome::converged) return row;
    row.fitted = true;
    const double inner = small_sample_profile(confidence, f.counts.n - f.counts.right);
    const auto interval = [&](Quantity q) {
        core::Interval found = profile_interval(f, data, q, inner);
        found.confidence = confidence;
        return found;
    };
    for (std::size_t i = 0; i < kLimitShares.size(); ++i) {
        const Quantity q = quantile_of(kLimitShares[i]);
        row.drifts[i] = {kLimitShares[i], value(f.law, q), interval(q)};
    }
    row.dispersion = f.law.dispersion;
    row.dispersion_interval = interval(dispersion());
    row.median_error = uncertain(f, median()).axis_error;
    row.predictive_dispersion = std::hypot(row.dispersion, row.median_error);
    return row;
}

} // namespace fragility
