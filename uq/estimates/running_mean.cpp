#include "uq/estimates/running_mean.hpp"

#include "core/critical.hpp"
#include "core/moments.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace uq {

namespace {

/// `left`: what the variance of a mean of j is short of sd^2 / j.
std::vector<RunningMean> run(std::span<const double> y, const Prescribed& reference,
                             double left, double scale, double factor)
{
    if (scale == 0.0)
        throw std::invalid_argument("the error relative to a mean of 0 is not defined");
    if (!std::isfinite(reference.mean) || !(reference.sd >= 0.0))
        throw std::invalid_argument(
            "the reference needs a finite mean and a standard deviation "
            ">= 0");
    std::vector<RunningMean> out;
    double mean = 0.0;
    std::size_t sound = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (!std::isnan(y[i])) {
            ++sound;
            mean += (y[i] - mean) / static_cast<double>(sound);
        }
        if (sound == 0) continue;
        const double variance = std::max(0.0, 1.0 / static_cast<double>(sound) - left);
        out.push_back({i + 1, sound, mean, (mean - reference.mean) / scale,
                       factor * reference.sd * std::sqrt(variance) / scale});
    }
    return out;
}

} // namespace

std::vector<RunningMean> running_mean(std::span<const double> y, const Prescribed& prescribed,
                                      bool relative, double confidence)
{
    if (sound_values(y).values.empty())
        throw std::invalid_argument("a running mean needs at least one sound sample");
    return run(y, prescribed, 0.0, relative ? std::abs(prescribed.mean) : 1.0,
               core::normal_factor(confidence));
}

std::vector<RunningMean> running_mean(std::span<const double> y, bool relative,
                                      double confidence)
{
    const SoundValues sound = sound_values(y);
    const core::Moments m = core::moments(sound.values);
    return run(y, {m.mean, m.sd}, 1.0 / static_cast<double>(sound.values.size()),
               relative ? std::abs(m.mean) : 1.0, core::normal_factor(confidence));
}

} // namespace uq
