#include "app/text/number_text.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <system_error>

namespace app {

namespace {

std::string to_text(double value, std::chars_format format, int digits)
{
    std::array<char, 400> text; // the largest double has 309 digits before the point
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
    assert(error == std::errc());
    return error == std::errc() ? std::string(text.data(), end) : std::string();
}

} // namespace

std::string number(double value, int digits)
{
    assert(digits >= 1 && digits <= 17);
    if (!std::isfinite(value)) return {};
    if (digits == 17) { // the shortest text that reads back as the same double
        std::array<char, 32> text;
        const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
        assert(error == std::errc());
        return {text.data(), end};
    }
    return to_text(value == 0.0 ? 0.0 : value, std::chars_format::general, digits);
}

double rounded(double value, int digits)
{
    const std::string text = number(value, digits);
    double x = value;
    std::from_chars(text.data(), text.data() + text.size(), x); // subnormal values too
    return x;
}

std::string fixed(double value, int decimals)
{
    assert(decimals >= 0 && decimals <= 17);
    if (!std::isfinite(value)) return {};
    const std::string text = to_text(value, std::chars_format::fixed, decimals);
    const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
    return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string never_rounded_away(double value, int decimals)
{
    const bool none_left = value != 0.0 && std::abs(value) < 0.5 * std::pow(10.0, -decimals);
    return none_left ? number(value, 2) : fixed(value, decimals);
}

} // namespace app
