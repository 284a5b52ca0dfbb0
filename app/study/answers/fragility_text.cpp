#include "app/study/answers/fragility_text.hpp"

#include "app/text/number_text.hpp"

namespace app {

Number median_bound(const fragility::MedianBound& bound, int decimals)
{
    if (!bound.median_bounded) return {};
    return {.lower = bound.median_above,
            .decimals = decimals,
            .sense = bound.strictly ? Sense::above : Sense::at_least};
}

Number limit_cell(const fragility::LimitDisplacement& limit, double scale, int decimals)
{
    if (!is_defined(limit)) return {};
    return {.value = limit.displacement * scale,
            .decimals = decimals,
            .sense = is_censored(limit) ? Sense::above : Sense::equal};
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
