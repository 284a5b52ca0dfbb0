#include "ground/pulse.hpp"

#include "ground/call_arguments.hpp"
#include "ground/record.hpp"
#include "ground/record_text.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ground {
namespace {

constexpr std::array<std::string_view, 5> kPulses = {"half_sine", "sine", "cosine", "ricker",
                                                     "mavroeidis_papageorgiou"};

/// How a pulse of this name is written.
std::string example_of(const std::string& name)
{
    if (name == "half_sine") return "half_sine(peak 0.5 g, duration 0.3 s)";
    if (name == "mavroeidis_papageorgiou")
        return "mavroeidis_papageorgiou(velocity 0.5 m/s, period 1 s, cycles 2, phase 0 deg)";
    return name + "(peak 0.5 g, period 0.6 s)";
}

/// Samples of f(t) on [0, duration], the last of them at its end.
template <class F>
GroundMotion sampled(std::string_view name, double duration, double step, F f)
{
    constexpr double kMost = 10e6;
    if (!(duration / step <= kMost))
        throw std::invalid_argument(
            "a step this small makes more than ten million samples; make it larger");
    const auto n = static_cast<std::size_t>(std::ceil(duration / step * (1.0 - 1e-12)));
    GroundMotion m{std::string(stripped(name)), duration / static_cast<double>(n), {}};
    for (std::size_t i = 0; i <= n; ++i)
        m.acceleration.push_back(f(m.step * static_cast<double>(i)));
    return m;
}

} // namespace

bool is_pulse(std::string_view text)
{
    const std::string_view name = stripped(text.substr(0, text.find('(')));
    if (text.find('(') == std::string_view::npos) return false;
    for (const std::string_view p : kPulses)
        if (p == name) return true;
    return false;
}

std::string pulse_names()
{
    std::string names;
    for (const std::string_view name : kPulses)
        names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
}

GroundMotion pulse(std::string_view text)
{
    const CallText call = parse_call(text);
    Arguments given(call, example_of(call.name));
    constexpr double kMostPeak = 1000.0, kLeastTime = 1e-3, kMostTime = 1000.0,
                     kPerPeriod = 400.0;
    const auto peak = [&] {
        return given.take("peak", Dimension::acceleration, -kMostPeak, kMostPeak);
    };
    const auto step_of = [&](double period) {
        const double step =
            given.take("step", Dimension::time, 1e-6, period, period / kPerPeriod);
        given.refuse_others();
        return step;
    };
    if (call.name == "half_sine") {
        const double a = peak(),
                     d = given.take("duration", Dimension::time, kLeastTime, kMostTime);
        return sampled(text, d, step_of(d),
                       [=](double t) { return a * std::sin(std::numbers::pi * t / d); });
    }
    if (call.name == "sine" || call.name == "cosine") {
        const double a = peak(),
                     period = given.take("period", Dimension::time, kLeastTime, kMostTime);
        const double cycles = given.take("cycles", Dimension::none, 0.25, 1000.0, 1.0),
                     w = 2.0 * std::numbers::pi / period;
        const double step = step_of(period),
                     shift = call.name == "sine" ? -0.5 * std::numbers::pi : 0.0;
        return sampled(text, cycles * period, step,
                       [=](double t) { return a * std::cos(w * t + shift); });
    }
    if (call.name == "ricker") {
        const double a = peak(),
                     period = given.take("period", Dimension::time, kLeastTime, kMostTime);
        constexpr double kHalf = 1.5; // [periods] beyond it |a| is below 1e-8 of the peak
        return sampled(text, 2.0 * kHalf * period, step_of(period), [=](double t) {
            const double s = std::numbers::pi * (t / period - kHalf);
            return a * (1.0 - 2.0 * s * s) * std::exp(-s * s);
        });
    }
    if (call.name == "mavroeidis_papageorgiou") {
        const double v = given.take("velocity", Dimension::velocity, -100.0, 100.0);
        const double period = given.take("period", Dimension::time, kLeastTime, kMostTime);
        const double c = given.take("cycles", Dimension::none, 1.0, 100.0, 2.0);
        const double phase = given.take("phase", Dimension::angle, -100.0, 100.0, 0.0),
                     w = 2.0 * std::numbers::pi / period;
        return sampled(text, c * period, step_of(period), [=](double t) {
            const double s = t - 0.5 * c * period, slow = w * s / c, fast = w * s + phase;
            return -0.5 * v * w / c *
                   (std::sin(slow) * std::cos(fast) +
                    c * std::sin(fast) * (1.0 + std::cos(slow)));
        });
    }
    throw std::invalid_argument(in_quotes(call.name) + " is no pulse; these are " +
                                pulse_names());
}

} // namespace ground
