#include "app/output/picture/axis_ticks.hpp"

#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr const char* kThinSpace = "\u2009";

/// 1, 2 or 5 times a power of ten, nearest above `step`.
double round_step(double step)
{
    const double decade = std::pow(10.0, std::floor(std::log10(step)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * decade >= step * (1.0 - 1e-9)) return factor * decade;
    return 10.0 * decade;
}

/// Multiples of powers of ten within [low, high].
std::vector<double> multiples(double low, double high, std::initializer_list<int> factors)
{
    std::vector<double> values;
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::floor(std::log10(high)));
    for (int decade = first; decade <= last; ++decade)
        for (const int factor : factors) {
            const double value = factor * std::pow(10.0, decade);
            if (value >= low && value <= high) values.push_back(value);
        }
    return values;
}

std::string superscript(int n)
{
    static constexpr std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                            "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = n < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(n))) text += kDigits[c - '0'];
    return text;
}

std::string power_text(double value)
{
    int exponent = static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-9));
    const std::string factor = number(value / std::pow(10.0, exponent), 6);
    if (factor == "1") return "10" + superscript(exponent);
    return factor + "·10" + superscript(exponent);
}

std::string grouped(std::string text)
{
    const std::size_t point = std::min(text.find('.'), text.size());
    const std::size_t first = text.front() == '-' ? 1 : 0;
    if (point - first < 5) return text; // 1000 to 9999 stay as they are
    for (std::size_t at = point; at > first + 3;) text.insert(at -= 3, kThinSpace);
    return text;
}

} // namespace

double Axis::share(double value) const
{
    if (log) return std::log(value / low) / std::log(high / low);
    return (value - low) / (high - low);
}

Axis linear_axis(double low, double high, int wanted)
{
    if (low > high) std::swap(low, high);
    const double largest = std::max(std::abs(low), std::abs(high));
    if (high - low <= 1e-9 * largest ||
        largest == 0.0) { // ticks would hardly differ as doubles
        const double around = largest == 0.0 ? 1.0 : 0.1 * largest;
        low -= around;
        high += around;
    }
    const double step = round_step((high - low) / wanted);
    constexpr double kSlack = 0.02;
    const double first = std::floor(low / step + kSlack),
                 last = std::ceil(high / step - kSlack);
    Axis axis;
    axis.low = first * step;
    axis.high = last * step;
    for (double k = first; k <= last; k += 1.0) axis.ticks.push_back(k * step);
    return axis;
}

Axis log_axis(double low, double high)
{
    if (low > high) std::swap(low, high);
    const double grow = low == high ? 2.0 : std::pow(high / low, 0.04);
    Axis axis;
    axis.log = true;
    axis.low = low / grow;
    axis.high = high * grow;
    axis.minor = multiples(axis.low, axis.high, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    axis.ticks = multiples(axis.low, axis.high, {1});
    if (axis.ticks.size() < 4) axis.ticks = multiples(axis.low, axis.high, {1, 2, 5});
    if (axis.ticks.size() < 3) {
        axis.ticks = linear_axis(axis.low, axis.high, 4).ticks;
        std::erase_if(axis.ticks, [&](double t) { return t < axis.low || t > axis.high; });
    }
    return axis;
}

std::string tick_label(const Axis& axis, double tick)
{
    if (tick == 0.0) return "0";
    const double largest = std::max(std::abs(axis.low), std::abs(axis.high));
    if (largest >= 1e7 || largest < 1e-3 || (axis.log && std::abs(tick) < 1e-3))
        return power_text(tick);
    if (axis.log || axis.ticks.size() < 2) return grouped(number(tick, 6));
    const double step = axis.ticks[1] - axis.ticks[0];
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-6)));
    return grouped(fixed(tick, std::min(decimals, 12)));
}

} // namespace app
