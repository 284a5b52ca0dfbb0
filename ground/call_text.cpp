#include "ground/call_text.hpp"

#include "ground/record.hpp"
#include "ground/record_text.hpp"

#include <cstdio>
#include <numbers>
#include <stdexcept>

namespace ground {
namespace {

[[noreturn]] void bad(const std::string& why) { throw std::invalid_argument(why); }

struct UnitRow {
    Dimension dimension;
    std::string_view name;
    double value;
};
constexpr UnitRow kUnits[] = {
    {Dimension::none, "", 1.0},
    {Dimension::acceleration, "g", kGravity},
    {Dimension::acceleration, "m/s2", 1.0},
    {Dimension::acceleration, "cm/s2", 1e-2},
    {Dimension::velocity, "m/s", 1.0},
    {Dimension::velocity, "cm/s", 1e-2},
    {Dimension::velocity, "mm/s", 1e-3},
    {Dimension::length, "m", 1.0},
    {Dimension::length, "cm", 1e-2},
    {Dimension::length, "mm", 1e-3},
    {Dimension::time, "s", 1.0},
    {Dimension::time, "ms", 1e-3},
    {Dimension::frequency, "Hz", 1.0},
    {Dimension::angle, "deg", std::numbers::pi / 180.0},
    {Dimension::angle, "rad", 1.0},
};

std::string units_of(Dimension dimension)
{
    std::string all;
    for (const UnitRow& u : kUnits)
        if (u.dimension == dimension) all += (all.empty() ? "" : " or ") + std::string(u.name);
    return all;
}

} // namespace

CallText parse_call(std::string_view text)
{
    text = stripped(text);
    const std::size_t open = text.find('(');
    CallText call{std::string(stripped(text.substr(0, open))), {}};
    if (open == std::string_view::npos) return call;
    if (!text.ends_with(')'))
        bad(in_quotes(text) +
            " has no bracket at its end; write e.g. \"half_sine(peak 0.5 g, duration 0.3 s)\"");
    std::string_view inside = text.substr(open + 1, text.size() - open - 2);
    if (stripped(inside).empty()) return call;
    for (;;) {
        const std::size_t comma = inside.find(',');
        const std::string_view part = stripped(inside.substr(0, comma));
        const std::size_t blank = part.find(' ');
        const bool named = !part.empty() && ((part[0] >= 'a' && part[0] <= 'z') ||
                                             (part[0] >= 'A' && part[0] <= 'Z'));
        if (part.empty() || (named && blank == std::string_view::npos))
            bad(in_quotes(part) +
                " is no value; write a name and a value, such as \"peak 0.5 g\"");
        if (named)
            call.arguments.push_back({std::string(part.substr(0, blank)),
                                      std::string(stripped(part.substr(blank)))});
        else
            call.arguments.push_back({"", std::string(part)});
        if (comma == std::string_view::npos) return call;
        inside.remove_prefix(comma + 1);
    }
}

double quantity(std::string_view text, Dimension dimension)
{
    text = stripped(text);
    std::size_t end = text.find_first_not_of("0123456789.+-eE");
    end = end == std::string_view::npos ? text.size() : end;
    const auto x = number_of(text.substr(0, end));
    const std::string_view unit = stripped(text.substr(end));
    if (!x) bad(in_quotes(text) + " is no number");
    for (const UnitRow& u : kUnits)
        if (u.dimension == dimension && u.name == unit) return *x * u.value;
    if (dimension == Dimension::none)
        bad(in_quotes(text) + " has a unit; write the number alone");
    bad(in_quotes(text) + " has no unit of the right kind; write " + units_of(dimension) +
        " after the number");
}

std::string plain_text(double x)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
}

} // namespace ground
