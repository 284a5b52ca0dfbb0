#include "app/study/fragility_text.hpp"

#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace app {

double known_to(std::span<const fragility::Observation> limits)
{
    double end = 0.0;
    for (const fragility::Observation& o : limits) end = std::max(end, o.lower);
    return end;
}

double common_end(std::span<const fragility::Observation> limits)
{
    const double largest = known_to(limits);
    double end = largest;
    for (const fragility::Observation& o : limits)
        if (o.lower < o.upper && o.lower >= largest * (1.0 - kEndsTogether))
            end = std::min(end, o.lower);
    return end;
}

std::string extrapolated_text(const std::string& whose)
{
    return "\u2020: extrapolated, beyond the largest drift at which " + whose +
           " reached the limit state or still stood where its curve ended";
}

Number with_interval(double value, const fragility::Interval& i, int decimals, double known_to)
{
    return with_interval(value, i.lower, i.upper, decimals, known_to);
}

Number median_bound(const fragility::MedianBound& bound, int decimals)
{
    if (!bound.median_bounded) return {};
    return {.lower = bound.median_above,
            .decimals = decimals,
            .sense = bound.strictly ? Sense::above : Sense::at_least};
}

std::string percent_text(double share) { return number(100.0 * share, 6) + " %"; }

std::string file_name(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string name;
    for (const char c : text) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '_';
        const bool continues = (c & 0xC0) == 0x80; // a character of UTF-8 is one sign
        if (!continues && name.size() < kMost) name += plain ? c : '_';
    }
    return name.empty() || name.front() == '.' ? "_" + name : name;
}

} // namespace app
