#include "app/input/study/units.hpp"

#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/scene/wall.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <system_error>
#include <utility>

namespace app {
namespace {

/// value in SI = value * times / over; one of them is 1, so that "300 mm" is the double 0.3.
struct Unit {
    std::string_view name;
    std::string_view quantity; ///< with its article, for messages
    double times;
    double over;
};

constexpr std::array kUnits = {
    Unit{"m", "a length", 1, 1},
    Unit{"cm", "a length", 1, 1e2},
    Unit{"mm", "a length", 1, 1e3},
    Unit{"Pa", "a stress", 1, 1},
    Unit{"kPa", "a stress", 1e3, 1},
    Unit{"MPa", "a stress", 1e6, 1},
    Unit{"GPa", "a stress", 1e9, 1},
    Unit{"N/mm2", "a stress", 1e6, 1},
    Unit{"kN/m2", "a stress", 1e3, 1},
    Unit{"bar", "a stress", 1e5, 1},
    Unit{"Pa/m", "a joint stiffness", 1, 1},
    Unit{"kPa/m", "a joint stiffness", 1e3, 1},
    Unit{"MPa/m", "a joint stiffness", 1e6, 1},
    Unit{"GPa/m", "a joint stiffness", 1e9, 1},
    Unit{"Pa/mm", "a joint stiffness", 1e3, 1},
    Unit{"N/mm3", "a joint stiffness", 1e9, 1},
    Unit{"kg/m3", "a density", 1, 1},
    Unit{"kN/m3", "a density", 1e3, dem::Loads{}.gravity}, // the weight that it has
    Unit{"N/m", "an energy per area", 1, 1},
    Unit{"J/m2", "an energy per area", 1, 1},
    Unit{"N/mm", "an energy per area", 1e3, 1},
    Unit{"rad", "an angle", 1, 1},
    Unit{"deg", "an angle", std::numbers::pi / 180, 1},
    Unit{"\u00b0", "an angle", std::numbers::pi / 180, 1},
    Unit{"N", "a force", 1, 1},
    Unit{"kN", "a force", 1e3, 1},
    Unit{"m/s2", "an acceleration", 1, 1},
    Unit{"%", "a percentage", 1, 1e2},
    Unit{"s", "a time", 1, 1},
    Unit{"min", "a time", 60, 1},
    Unit{"", "a number without unit", 1, 1},
};

const Unit& unit_named(std::string_view name)
{
    const auto found =
        std::ranges::find_if(kUnits, [&](const Unit& u) { return u.name == name; });
    assert(found != kUnits.end());
    return *found;
}

double si_value(double value, const Unit& unit) { return value * unit.times / unit.over; }

/// Names of the units of the same quantity, its SI unit first.
std::vector<std::string_view> alternatives(const Unit& unit)
{
    std::vector<std::string_view> names;
    for (const Unit& u : kUnits) {
        if (u.quantity == unit.quantity) names.push_back(u.name);
    }
    return names;
}

std::string example(std::string_view number, const Unit& unit)
{
    return in_quotes(std::string(number) + (unit.name.empty() ? "" : " ") +
                     std::string(unit.name));
}

[[noreturn]] void refuse_number(std::string_view text, const std::string& what,
                                const Unit& unit)
{
    throw BadValue(in_quotes(text) + " is " + what + "; write " +
                   (unit.name.empty() ? "a number" : "a number and its unit") + ", such as " +
                   example("1", unit));
}

/// The unit that was probably meant: a wall of 200 m is one of 200 mm.
const Unit& likely_unit(double number, const Unit& unit)
{
    constexpr double kNoWall = 50.0; // [m]
    return unit.name == "m" && number >= kNoWall ? unit_named("mm") : unit;
}

struct Parts {
    double number = 0.0;
    std::string_view number_text;
    std::string_view unit;
};

/// "31.8 deg" -> 31.8, "31.8", "deg"
Parts number_and_unit(std::string_view text, const Unit& unit)
{
    const std::size_t sign = text.find_first_of("+-") == 0 ? 1 : 0;
    if (text.find_first_of("0123456789.", sign) != sign) {
        refuse_number(text, "not a finite number", unit); // also nan and inf
    }
    const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
    Parts parts;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), parts.number);
    if (error == std::errc::result_out_of_range) {
        refuse_number(text, "beyond the range of a double", unit);
    }
    parts.number_text = text.substr(0, static_cast<std::size_t>(end - text.data()));
    const std::string_view rest = text.substr(parts.number_text.size());
    if (rest.starts_with('x') || rest.starts_with('X')) {
        refuse_number(text, "not a decimal number", unit);
    }
    parts.unit = trimmed(rest);
    if (parts.unit.find_first_of("0123456789.+-") == 0) {
        refuse_number(text, "not one decimal number", unit);
    }
    return parts;
}

/// "kg/m3" of "kg/m³" and of "kg/m^3".
std::string plain(std::string_view unit)
{
    std::string name(unit);
    for (const auto& [sign, digit] :
         {std::pair{"\u00b2", "2"}, {"\u00b3", "3"}, {"^2", "2"}, {"^3", "3"}})
        if (const std::size_t at = name.find(sign); at != std::string::npos)
            name.replace(at, std::string_view(sign).size(), digit);
    return name;
}

double in_si(const Parts& parts, const Unit& expected)
{
    const auto names = alternatives(expected);
    const std::string name = plain(parts.unit);
    if (std::ranges::find(names, name) == names.end()) {
        const std::string is = "unit " + in_quotes(parts.unit);
        if (parts.unit.starts_with('/')) {
            throw BadValue(in_quotes(std::string(parts.number_text) + std::string(parts.unit)) +
                           " is a fraction; write it as a decimal number, such as 0.3333");
        }
        if (expected.name.empty() && parts.unit == "%") {
            throw BadValue("a percentage where a number belongs; write " +
                           in_quotes(number(parts.number / 100.0, 12)));
        }
        if (expected.name.empty()) {
            throw BadValue(is + " where none belongs; write " + in_quotes(parts.number_text));
        }
        throw BadValue(is + " is not " + std::string(expected.quantity) + "; use " +
                       listed(names));
    }
    const double value = si_value(parts.number, unit_named(name));
    if (!std::isfinite(value)) {
        refuse_number(parts.number_text, "beyond the range of a double", expected);
    }
    return value;
}

/// The remedy for a comma before no blank: it may have been the point of a decimal number, or
/// part of a list.
std::string without_doubt(std::string_view text, std::size_t comma)
{
    std::string point(text), list;
    point[comma] = '.';
    for (const std::string_view item : split(text, ","))
        list += (list.empty() ? "" : ", ") + std::string(item);
    const bool several = text.find(',', comma + 1) != std::string_view::npos;
    const bool sign =
        comma + 1 < text.size() && (text[comma + 1] == '-' || text[comma + 1] == '+');
    if (several || sign) return "a blank after each comma of a list, " + in_quotes(list);
    return "a decimal point, " + in_quotes(point) + ", or a list with blanks, " +
           in_quotes(list);
}

/// A comma ends an item of a list only before a blank, so that "0,15" is never read as 0
/// and 15.
std::vector<std::string_view> unit_words(std::string_view text)
{
    std::vector<std::string_view> found;
    for (std::size_t begin = 0, comma = 0; comma != std::string_view::npos; begin = comma + 1) {
        comma = text.find(',', begin);
        if (comma != std::string_view::npos && comma + 1 < text.size() &&
            text[comma + 1] != ' ' && text[comma + 1] != '\t') {
            throw BadValue("comma inside " + in_quotes(text) + "; write " +
                           without_doubt(text, comma));
        }
        found.push_back(trimmed(text.substr(begin, comma - begin)));
        if (found.back().empty()) {
            throw BadValue("empty place in the list " + in_quotes(text) +
                           "; write a number between two commas");
        }
    }
    return found;
}

/// A small number in place of an angle may be the coefficient of friction.
std::string or_its_angle(const std::vector<Parts>& parts, std::string_view unit)
{
    constexpr double kMostCoefficient = 2.0, kDegrees = 180.0 / std::numbers::pi;
    if (unit != "deg" || parts.size() != 1) return "";
    const double x = parts.front().number;
    if (!(x > 0.0 && x <= kMostCoefficient)) return "";
    return ", or \"" + number(std::atan(x) * kDegrees, 4) +
           " deg\" where it is the coefficient of friction";
}

} // namespace

std::vector<double> parse_quantities(std::string_view text, std::string_view unit)
{
    const Unit& expected = unit_named(unit);
    std::vector<Parts> parts;
    for (const std::string_view item : unit_words(text))
        parts.push_back(number_and_unit(item, expected));
    const auto is_bare = [](const Parts& p) { return p.unit.empty(); };
    if (std::all_of(parts.begin(), parts.end() - 1, is_bare)) {
        for (Parts& p : parts) p.unit = parts.back().unit;
    }
    if (!unit.empty() && std::ranges::any_of(parts, is_bare)) {
        throw BadValue(is_bare(parts.back()) && is_bare(parts.front())
                           ? "missing unit; write " +
                                 example(text, likely_unit(parts.back().number, expected)) +
                                 or_its_angle(parts, unit)
                           : "missing unit in " + in_quotes(text) +
                                 "; write it once at the end, or on each value");
    }
    std::vector<double> values;
    for (const Parts& p : parts) values.push_back(in_si(p, expected));
    return values;
}

double parse_quantity(std::string_view text, std::string_view unit)
{
    const std::vector<double> values = parse_quantities(text, unit);
    if (values.size() != 1) {
        throw BadValue(std::to_string(values.size()) +
                       " values where one belongs; write one of them");
    }
    return values.front();
}

double parse_count(std::string_view text)
{
    constexpr double kLargest = 9007199254740992.0; // 2^53: above it a double skips integers
    const double value = parse_quantity(text, "");
    if (value != std::floor(value) || std::abs(value) > kLargest) {
        throw BadValue(in_quotes(text) + " is not a whole number; write one, such as \"10\"");
    }
    return value;
}

double from_si(double si, std::string_view unit)
{
    const Unit& u = unit_named(unit);
    return si * u.over / u.times;
}

std::string_view si_unit(std::string_view unit)
{
    return alternatives(unit_named(unit)).front();
}

double to_si(double value, std::string_view unit) { return si_value(value, unit_named(unit)); }

std::string quantity_text(double si, std::string_view unit)
{
    return number(from_si(si, unit), 12) + " " + std::string(unit);
}

std::string format_quantities(std::span<const double> si, std::string_view unit)
{
    const Unit& wanted = unit_named(unit);
    constexpr int kEvery = 17, kFew = 15;
    const auto text_in = [&](const Unit& u, int digits) {
        std::string text;
        for (const double value : si) {
            const double shown = value * u.over / u.times;
            const std::string every = number(shown, kEvery), few = number(shown, digits);
            text += (text.empty() ? "" : ", ") + (few.size() < every.size() ? few : every);
        }
        return text + (u.name.empty() ? "" : " ") + std::string(u.name);
    };
    for (const int digits : {kFew, kEvery}) { // 30 deg rather than 29.999999999999996 deg
        const std::string text = text_in(wanted, digits);
        if (std::ranges::equal(si, parse_quantities(text, unit))) return text;
    }
    return text_in(unit_named(alternatives(wanted).front()), kEvery);
}

} // namespace app
