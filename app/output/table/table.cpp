#include "app/output/table/table.hpp"

#include "app/output/table/cells.hpp"
#include "app/text/number_text.hpp"
#include "fragility/fits/observation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace app {

namespace {

constexpr std::string_view kDagger = "\u2020";

const std::string* text_of(const Cell& cell) { return std::get_if<std::string>(&cell); }
const Number* number_of(const Cell& cell) { return std::get_if<Number>(&cell); }

bool extrapolated(const Number& n, double x) { return !fragility::is_known(x, n.known_to); }

std::string digits(const Number& n, double x)
{
    if (n.decimals == kShortest) return number(x, 12);
    return fixed(x, n.decimals);
}

std::string marked(const Number& n, double x)
{
    return digits(n, x) + std::string(extrapolated(n, x) ? kDagger : "");
}

/// So that a lower bound stays one.
std::string rounded_down(const Number& n, double x)
{
    const std::string nearest = digits(n, x);
    if (n.decimals == kShortest || std::stod(nearest) <= x) return nearest;
    return fixed(std::stod(nearest) - std::pow(10.0, -n.decimals), n.decimals);
}

std::string bound(const Number& n, double x)
{
    return std::isinf(x) ? "no limit" : marked(n, x);
}

std::string number_cell(const Number& n)
{
    const bool value = std::isfinite(n.value);
    const bool range = !std::isnan(n.lower) && !std::isnan(n.upper);
    if (n.sense != Sense::equal) {
        const double least = value ? n.value : n.lower;
        if (!std::isfinite(least)) return {};
        const std::string text =
            (n.sense == Sense::above ? "> " : ">= ") + rounded_down(n, least);
        const bool wider = value && range && n.lower < least;
        return wider ? text + " [" + rounded_down(n, n.lower) + ", " + bound(n, n.upper) + "]"
                     : text;
    }
    if (!value) return range ? bound(n, n.lower) + " to " + bound(n, n.upper) : std::string();
    if (range)
        return marked(n, n.value) + " [" + bound(n, n.lower) + ", " + bound(n, n.upper) + "]";
    if (std::isfinite(n.error))
        return marked(n, n.value) + " +- " +
               (n.decimals == kShortest ? digits(n, n.error)
                                        : never_rounded_away(n.error, n.decimals));
    return marked(n, n.value);
}

/// "median [%]" and "lower": "median lower [%]"
std::string head_with(const std::string& head, const std::string& what)
{
    const auto unit = head.rfind(" [");
    if (unit == std::string::npos) return head + " " + what;
    return head.substr(0, unit) + " " + what + head.substr(unit);
}

std::string without_unit(const std::string& head) { return head.substr(0, head.rfind(" [")); }

std::vector<std::string> plain_names(const Head& c)
{
    std::vector<std::string> names;
    if ((c.holds & kRange) == 0) names.push_back(c.name);
    if (c.holds & kExtrapolated) names.push_back(without_unit(c.name) + " extrapolated");
    if (c.holds & kCensored) names.push_back(without_unit(c.name) + " censored");
    if (c.holds & kError) names.push_back(head_with(c.name, "std error"));
    if (c.holds & (kInterval | kRange)) {
        names.push_back(head_with(c.name, "lower"));
        names.push_back(head_with(c.name, "upper"));
    }
    return names;
}

/// Values without decimals of their own are inputs, which programs get to the bit.
PlainTable::Value finite(const Number& n, double x)
{
    if (!std::isfinite(x)) return {};
    return n.decimals == kShortest ? x : rounded(x, kAfterUnits);
}

void add_plain(const Head& c, const Cell& cell, std::vector<PlainTable::Value>& row)
{
    const Number* const given = number_of(cell);
    const Number n = given ? *given : Number{};
    const bool value = std::isfinite(n.value);
    const auto flag = [&](bool yes) {
        return value ? PlainTable::Value(yes ? 1.0 : 0.0) : PlainTable::Value();
    };
    const std::string* const text = text_of(cell);
    if ((c.holds & kRange) == 0)
        row.push_back(text && !text->empty() ? PlainTable::Value(*text) : finite(n, n.value));
    if (c.holds & kExtrapolated) row.push_back(flag(extrapolated(n, n.value)));
    if (c.holds & kCensored)
        row.push_back(value || std::isfinite(n.lower)
                          ? PlainTable::Value(n.sense != Sense::equal ? 1.0 : 0.0)
                          : PlainTable::Value());
    if (c.holds & kError) row.push_back(finite(n, n.error));
    if (c.holds & (kInterval | kRange)) {
        row.push_back(finite(n, n.lower));
        row.push_back(finite(n, n.upper));
    }
}

} // namespace

Number given(double x) { return {.value = rounded(x, 12)}; }

Row joined(Row start, Row more)
{
    std::ranges::move(more, std::back_inserter(start));
    return start;
}

void add_row(Table& table, Row cells, std::string note)
{
    cells.resize(table.head.size());
    if (!note.empty()) cells.back() = std::move(note);
    table.rows.push_back(std::move(cells));
}

int decimals_for(double size)
{
    if (!std::isfinite(size) || size == 0.0) return 3;
    const int magnitude = static_cast<int>(std::floor(std::log10(std::abs(size))));
    return std::clamp(2 - magnitude, 0, 6);
}

std::string cell_text(const Cell& cell)
{
    if (const std::string* const text = text_of(cell)) return *text;
    const Number* const n = number_of(cell);
    return n ? number_cell(*n) : std::string();
}

ShownTable shown(const Table& t)
{
    ShownTable s;
    for (const Head& c : t.head)
        if ((c.holds & (kProgramsOnly | kNote)) == 0) s.head.push_back(c.name);
    const bool noted =
        std::ranges::any_of(t.head, [](const Head& c) { return (c.holds & kNote) != 0; });
    std::vector<std::string> marks;
    for (const Row& row : t.rows) {
        std::vector<std::string> cells;
        std::string mark;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string text = cell_text(row[c]);
            if ((t.head[c].holds & (kProgramsOnly | kNote)) == 0) cells.push_back(text);
            if ((t.head[c].holds & kNote) == 0 || text.empty()) continue;
            const auto known = std::ranges::find(s.notes, text);
            mark += "[" + std::to_string(known - s.notes.begin() + 1) + "]";
            if (known == s.notes.end()) s.notes.push_back(text);
        }
        if (noted) cells.push_back(mark);
        s.rows.push_back(std::move(cells));
    }
    if (noted) s.head.emplace_back("note");
    if (noted && s.notes.empty()) {
        s.head.pop_back();
        for (auto& row : s.rows) row.pop_back();
    }
    for (std::size_t i = 0; i < s.notes.size(); ++i)
        s.notes[i] = "[" + std::to_string(i + 1) + "] " + s.notes[i];
    return s;
}

PlainTable plain(const Table& t)
{
    PlainTable p;
    for (const Head& c : t.head)
        for (std::string& name : plain_names(c)) p.head.push_back(std::move(name));
    for (std::size_t i = 0; i < p.head.size(); ++i)
        while (std::ranges::count(p.head, p.head[i]) > 1) p.head[i] += " (group)";
    for (const Row& row : t.rows) {
        p.rows.emplace_back();
        for (std::size_t c = 0; c < row.size(); ++c)
            add_plain(t.head[c], row[c], p.rows.back());
    }
    return p;
}

} // namespace app
