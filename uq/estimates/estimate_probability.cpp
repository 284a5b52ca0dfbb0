#include "core/binomial.hpp"
#include "uq/estimates/estimate.hpp"

#include "core/critical.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

Estimate estimate_probability(std::size_t hits, std::size_t n, std::size_t failed,
                              double confidence, core::BinomialInterval kind)
{
    core::check_confidence(confidence);
    if (n == 0) throw std::invalid_argument("a probability needs at least one sound sample");
    if (hits > n)
        throw std::invalid_argument("hits are " + std::to_string(hits) + " of " +
                                    std::to_string(n) + " samples");
    const auto h = static_cast<double>(hits), all = static_cast<double>(n + failed);
    const double lowest = h / all, highest = (h + static_cast<double>(failed)) / all;
    const double widest = std::clamp(0.5, lowest, highest);
    return {
        h / static_cast<double>(n),
        std::sqrt(widest * (1.0 - widest) / static_cast<double>(n)),
        n,
        failed,
        {core::binomial_interval(kind, h, all, confidence).lower,
         core::binomial_interval(kind, h + static_cast<double>(failed), all, confidence).upper,
         confidence}};
}

Estimate estimate_probability_below(std::span<const double> y, double threshold,
                                    double confidence, core::BinomialInterval kind)
{
    if (std::isnan(threshold)) throw std::invalid_argument("the threshold is not a number");
    const SoundValues sound = sound_values(y);
    const auto hits = std::count_if(sound.values.begin(), sound.values.end(),
                                    [threshold](double x) { return x <= threshold; });
    return estimate_probability(static_cast<std::size_t>(hits), sound.values.size(),
                                sound.failed, confidence, kind);
}

} // namespace uq
