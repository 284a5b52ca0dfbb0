#include "app/drawing/svg_geometry.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/text/number_text.hpp"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <system_error>

namespace app {
namespace {

constexpr std::string_view kBlank = " \t\r\n\f";

/// Takes numbers and letters from the front of a text.
struct SvgReader {
    SvgPlace place;
    std::string_view rest;

    void skip_blanks()
    {
        const std::size_t n = rest.find_first_not_of(kBlank);
        rest.remove_prefix(n == std::string_view::npos ? rest.size() : n);
    }
    void skip_separator()
    {
        skip_blanks();
        if (rest.starts_with(',')) rest.remove_prefix(1);
        skip_blanks();
    }
    [[nodiscard]] bool at_number()
    {
        skip_separator();
        return !rest.empty() &&
               std::string_view("+-.0123456789").find(rest.front()) != std::string_view::npos;
    }
    double number()
    {
        skip_separator();
        if (rest.starts_with('+')) rest.remove_prefix(1);
        double value = 0.0;
        const bool digit =
            !rest.empty() &&
            std::string_view("-.0123456789").find(rest.front()) != std::string_view::npos;
        const auto [end, error] =
            std::from_chars(rest.data(), rest.data() + rest.size(), value);
        if (!digit || error != std::errc() || !std::isfinite(value) || std::abs(value) > 1e12) {
            refuse(*place.frame, place.line,
                   "expected a number at \"" + readable_name(rest.substr(0, 20)) +
                       "\"; export the drawing again");
        }
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        return value;
    }
};

std::string svg_coordinates(SvgPoint p)
{
    return "(" + number(p.x, 8) + ", " + number(p.y, 8) + ")";
}

PlaneTransform transform_of(const SvgPlace& place, std::string_view name,
                            const std::vector<double>& v)
{
    const std::size_t n = v.size();
    constexpr double kRadians = std::numbers::pi / 180.0;
    if (name == "matrix" && n == 6) return {v[0], v[1], v[2], v[3], v[4], v[5]};
    if (name == "translate" && (n == 1 || n == 2))
        return {1, 0, 0, 1, v[0], n == 2 ? v[1] : 0.0};
    if (name == "scale" && (n == 1 || n == 2)) return {v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0};
    if (name == "skewX" && n == 1) return {1, 0, std::tan(v[0] * kRadians), 1, 0, 0};
    if (name == "skewY" && n == 1) return {1, std::tan(v[0] * kRadians), 0, 1, 0, 0};
    if (name == "rotate" && (n == 1 || n == 3)) {
        const double c = std::cos(v[0] * kRadians), s = std::sin(v[0] * kRadians);
        const PlaneTransform turn{c, s, -s, c, 0, 0};
        if (n == 1) return turn;
        return PlaneTransform{1, 0, 0, 1, v[1], v[2]} * turn *
               PlaneTransform{1, 0, 0, 1, -v[1], -v[2]};
    }
    refuse(*place.frame, place.line,
           "the transform \"" + readable_name(name.substr(0, 40)) + "\" with " +
               counted(n, "number", "numbers") +
               " is unknown; apply the transforms in the drawing program");
}

struct Pen {
    SvgPoint at, begin;
    SvgPoint control; ///< the last of a curve that ends at `at`
    std::vector<SvgSubpath> paths;

    void move(SvgPoint p)
    {
        at = begin = control = p;
        paths.push_back({{p}, false});
    }
    void draw(SvgPoint p)
    {
        if (paths.empty() || paths.back().closed) paths.push_back({{at}, false});
        paths.back().points.push_back(p);
        at = control = p;
    }
    void close()
    {
        if (!paths.empty()) paths.back().closed = true;
        at = control = begin;
    }
};

[[noreturn]] void refuse_curve(const SvgPlace& place, char command, SvgPoint begin)
{
    refuse(*place.frame, place.line,
           "a path has a curve (" + std::string(1, command) + ") that begins at " +
               svg_coordinates(begin) +
               " before transforms; convert it to straight pieces (in Inkscape: Extensions, "
               "Modify Path, Flatten Beziers)");
}

/// One command with one set of numbers. Upper-case letters take coordinates, lower-case ones
/// distances.
void follow(Pen& pen, SvgReader& reader, char command)
{
    const bool relative = command >= 'a';
    const SvgPoint from = relative ? pen.at : SvgPoint{};
    switch (command) {
    case 'H':
    case 'h':
        pen.draw({from.x + reader.number(), pen.at.y});
        break;
    case 'V':
    case 'v':
        pen.draw({pen.at.x, from.y + reader.number()});
        break;
    default: {
        const double x = reader.number(), y = reader.number();
        const SvgPoint to{from.x + x, from.y + y};
        if (command == 'M' || command == 'm')
            pen.move(to);
        else
            pen.draw(to);
    }
    }
}

/// Whether a curve that has this control point stays within a thousandth of its chord.
bool is_near_chord(SvgPoint from, SvgPoint to, SvgPoint control)
{
    constexpr double kNear = 1e-3;
    const double cx = to.x - from.x, cy = to.y - from.y;
    const double dx = control.x - from.x, dy = control.y - from.y;
    const double square = cx * cx + cy * cy, along = dx * cx + dy * cy;
    return std::abs(dx * cy - dy * cx) <= kNear * square && along >= -kNear * square &&
           along <= (1.0 + kNear) * square && (square > 0.0 || (dx == 0.0 && dy == 0.0));
}

/// One Bezier curve, which must be a straight side: drawing programs write sides so that were
/// curves once. A smooth one (S, T) begins in the direction in which the last one ended.
/// @param last the command before, which tells whether there is one
void follow_curve(Pen& pen, SvgReader& reader, char command, char last)
{
    const bool relative = command >= 'a';
    const SvgPoint begin = pen.at, from = relative ? begin : SvgPoint{};
    const auto point = [&] {
        const double x = reader.number(), y = reader.number();
        return SvgPoint{from.x + x, from.y + y};
    };
    const auto is = [](char c, std::string_view any) {
        return any.find(c) != std::string_view::npos;
    };
    std::vector<SvgPoint> controls;
    if (is(command, "SsTt")) {
        const bool goes_on = is(last, is(command, "Ss") ? "CcSs" : "QqTt");
        const SvgPoint c = goes_on ? pen.control : begin;
        controls.push_back({2.0 * begin.x - c.x, 2.0 * begin.y - c.y});
    }
    const int more = is(command, "Cc") ? 2 : is(command, "Tt") ? 0 : 1;
    for (int i = 0; i < more; ++i) controls.push_back(point());
    const SvgPoint to = point();
    for (const SvgPoint& control : controls)
        if (!is_near_chord(begin, to, control)) refuse_curve(reader.place, command, begin);
    pen.draw(to);
    pen.control = controls.back();
}

} // namespace

SvgPoint apply(const PlaneTransform& t, SvgPoint p)
{
    return {t.a * p.x + t.c * p.y + t.e, t.b * p.x + t.d * p.y + t.f};
}

PlaneTransform svg_transform(const SvgPlace& place, std::string_view text)
{
    PlaneTransform whole;
    SvgReader reader{place, text};
    while (reader.skip_separator(), !reader.rest.empty()) {
        const std::size_t open = reader.rest.find('('), close = reader.rest.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
            refuse(*place.frame, place.line,
                   "the transform \"" + readable_name(text.substr(0, 40)) +
                       "\" has no numbers in brackets; export the drawing again");
        }
        std::string_view name = reader.rest.substr(0, open);
        name = name.substr(0, name.find_last_not_of(kBlank) + 1);
        std::vector<double> numbers;
        SvgReader inner{place, reader.rest.substr(open + 1, close - open - 1)};
        while (numbers.size() < 7 && inner.at_number()) numbers.push_back(inner.number());
        inner.skip_separator();
        if (!inner.rest.empty()) inner.number(); // refuses what is none
        whole = whole * transform_of(place, name, numbers);
        reader.rest.remove_prefix(close + 1);
    }
    return whole;
}

std::vector<SvgPoint> svg_points(const SvgPlace& place, std::string_view text)
{
    std::vector<SvgPoint> points;
    SvgReader reader{place, text};
    while (reader.skip_separator(), !reader.rest.empty()) {
        const double x = reader.number();
        points.push_back({x, reader.number()});
    }
    return points;
}

std::vector<SvgSubpath> svg_path(const SvgPlace& place, std::string_view text)
{
    Pen pen;
    SvgReader reader{place, text};
    char command = '\0', last = '\0';
    while (reader.skip_separator(), !reader.rest.empty()) {
        if (!reader.at_number()) {
            command = reader.rest.front();
            reader.rest.remove_prefix(1);
            if (command == 'A' || command == 'a') refuse_curve(place, command, pen.at);
            if (std::string_view("MmLlHhVvZzCcSsQqTt").find(command) ==
                std::string_view::npos) {
                refuse(*place.frame, place.line,
                       "a path has the command \"" + readable_name(std::string(1, command)) +
                           "\", which is unknown; export the drawing again");
            }
        } else if (command == '\0' || command == 'Z' || command == 'z') {
            refuse(*place.frame, place.line,
                   "a path has numbers without a command; export the drawing again");
        }
        if (command == 'Z' || command == 'z') {
            pen.close();
            last = command;
            continue;
        }
        if (std::string_view("CcSsQqTt").find(command) != std::string_view::npos)
            follow_curve(pen, reader, command, last);
        else
            follow(pen, reader, command);
        last = command;
        if (command == 'M') command = 'L'; // further points of a move are drawn
        if (command == 'm') command = 'l';
    }
    return pen.paths;
}

double svg_length(const SvgPlace& place, std::string_view name, std::string_view text)
{
    SvgReader reader{place, text};
    const double value = reader.number();
    reader.skip_blanks();
    if (reader.rest.empty() || reader.rest == "px") return value;
    refuse(*place.frame, place.line,
           std::string(name) + " is \"" + readable_name(text.substr(0, 40)) +
               "\"; give it without a unit, in units of the drawing");
}

} // namespace app
