#include "uq/estimates/estimate.hpp"

#include "core/critical.hpp"
#include "core/moments.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

Estimate with_interval(double value, double std_error, const SoundValues& y, double factor,
                       double confidence)
{
    return {value,
            std_error,
            y.values.size(),
            y.failed,
            {value - factor * std_error, value + factor * std_error, confidence}};
}

} // namespace

SoundValues sound_values(std::span<const double> y)
{
    SoundValues sound{{}, 0};
    sound.values.reserve(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (std::isinf(y[i]))
            throw std::invalid_argument("value " + std::to_string(i) +
                                        " is infinite: mark a failed sample by NaN");
        if (std::isnan(y[i]))
            ++sound.failed;
        else
            sound.values.push_back(y[i]);
    }
    return sound;
}

Estimate estimate_mean(std::span<const double> y, double confidence)
{
    core::check_confidence(confidence);
    const SoundValues sound = sound_values(y);
    const core::Moments m = core::moments(sound.values);
    const auto n = static_cast<double>(sound.values.size());
    return with_interval(m.mean, m.sd / std::sqrt(n), sound,
                         core::student_factor(confidence, n - 1.0), confidence);
}

Estimate estimate_mean(std::span<const double> y, double lower, double upper, double confidence)
{
    for (const double x : y)
        if (x < lower || x > upper)
            throw std::invalid_argument("an answer of " + std::to_string(x) +
                                        " is outside its bounds " + std::to_string(lower) +
                                        " .. " + std::to_string(upper));
    Estimate e = estimate_mean(y, confidence);
    const auto n = static_cast<double>(e.n), failed = static_cast<double>(e.failed);
    if (e.failed > 0) {
        e.interval.lower = (n * e.interval.lower + failed * lower) / (n + failed);
        e.interval.upper = (n * e.interval.upper + failed * upper) / (n + failed);
    }
    return e;
}

} // namespace uq
