#include "uq/estimates/estimate.hpp"

#include "uq/estimates/estimate_critical.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace uq {

namespace {

/// A sum and what rounding took from it (Neumaier 1974).
class CompensatedSum {
  public:
    void add(double x)
    {
        const double total = sum_ + x;
        lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - total) + x : (x - total) + sum_;
        sum_ = total;
    }
    [[nodiscard]] double value() const { return sum_ + lost_; }

  private:
    double sum_ = 0.0, lost_ = 0.0;
};

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

Moments moments(std::span<const double> y)
{
    if (y.size() < 2)
        throw std::invalid_argument("at least 2 sound samples are needed, got " +
                                    std::to_string(y.size()));
    const auto n = static_cast<double>(y.size());
    CompensatedSum from_first; // differences from a value of the sample lose no digits
    for (const double x : y) from_first.add(x - y[0]);
    const double shift = from_first.value() / n;
    CompensatedSum first, second;
    for (const double x : y) {
        const double d = (x - y[0]) - shift;
        first.add(d);
        second.add(d * d);
    }
    const double squares = second.value() - first.value() * first.value() / n;
    return {y[0] + shift, std::sqrt(std::max(0.0, squares) / (n - 1.0))};
}

Estimate estimate_mean(std::span<const double> y, double confidence)
{
    check_confidence(confidence);
    const SoundValues sound = sound_values(y);
    const Moments m = moments(sound.values);
    const auto n = static_cast<double>(sound.values.size());
    return with_interval(m.mean, m.sd / std::sqrt(n), sound,
                         student_factor(confidence, n - 1.0), confidence);
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
