#include "uq/estimates/estimate.hpp"

#include "uq/estimates/estimate_critical.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

Interval wilson(double hits, double n, double confidence)
{
    const double z = normal_factor(confidence), share = hits / n;
    const double middle = share + z * z / (2.0 * n);
    const double half = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    const double scale = 1.0 + z * z / n;
    return {hits == 0.0 ? 0.0 : (middle - half) / scale,
            hits == n ? 1.0 : (middle + half) / scale, confidence};
}

Interval clopper_pearson(double hits, double n, double confidence)
{
    const double tail = 0.5 * (1.0 - confidence);
    return {hits == 0.0 ? 0.0 : gsl_cdf_beta_Pinv(tail, hits, n - hits + 1.0),
            hits == n ? 1.0 : gsl_cdf_beta_Qinv(tail, hits + 1.0, n - hits), confidence};
}

} // namespace

Estimate estimate_probability(std::size_t hits, std::size_t n, std::size_t failed,
                              double confidence, ProportionInterval kind)
{
    check_confidence(confidence);
    if (n == 0) throw std::invalid_argument("a probability needs at least one sound sample");
    if (hits > n)
        throw std::invalid_argument("hits are " + std::to_string(hits) + " of " +
                                    std::to_string(n) + " samples");
    const auto h = static_cast<double>(hits), all = static_cast<double>(n + failed);
    const auto interval = kind == ProportionInterval::wilson ? wilson : clopper_pearson;
    const double lowest = h / all, highest = (h + static_cast<double>(failed)) / all;
    const double widest = std::clamp(0.5, lowest, highest);
    return {h / static_cast<double>(n),
            std::sqrt(widest * (1.0 - widest) / static_cast<double>(n)),
            n,
            failed,
            {interval(h, all, confidence).lower,
             interval(h + static_cast<double>(failed), all, confidence).upper, confidence}};
}

Estimate estimate_probability_below(std::span<const double> y, double threshold,
                                    double confidence, ProportionInterval kind)
{
    if (std::isnan(threshold)) throw std::invalid_argument("the threshold is not a number");
    const SoundValues sound = sound_values(y);
    const auto hits = std::count_if(sound.values.begin(), sound.values.end(),
                                    [threshold](double x) { return x <= threshold; });
    return estimate_probability(static_cast<std::size_t>(hits), sound.values.size(),
                                sound.failed, confidence, kind);
}

} // namespace uq
