#include "ground/record_head.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ground {
namespace {

bool is_time(std::string_view unit)
{
    constexpr std::array<std::string_view, 7> kTimes = {"s",  "sec",  "second", "seconds",
                                                        "ms", "msec", "min"};
    return std::ranges::find(kTimes, lower(unit)) != kTimes.end();
}

bool is_length(std::string_view unit)
{
    constexpr std::array<std::string_view, 6> kLengths = {"m", "mm", "cm", "km", "in", "ft"};
    return std::ranges::find(kLengths, unit) != kLengths.end();
}

/// Whether a unit is one of acceleration that is not known here, such as mg or ft/s2.
bool is_odd_acceleration(std::string_view text)
{
    const std::string unit = lower(text);
    const std::size_t bar = unit.find('/');
    return acceleration_unit(unit) == 0.0 &&
           (unit == "mg" || unit == "%g" || unit.starts_with("g/") ||
            (bar != std::string::npos && is_length(unit.substr(0, bar)) &&
             unit.find_first_of("2*/", bar + 1) != std::string::npos));
}

/// Whether a unit in brackets is one of another quantity, or not known here.
bool is_odd_unit(std::string_view text)
{
    std::string unit = lower(text);
    std::erase(unit, ' ');
    const bool per_time = unit.ends_with("-1") || unit.ends_with("\xC2\xB9"); // superscript 1
    return acceleration_unit(unit) == 0.0 &&
           (is_odd_acceleration(unit) || unit.starts_with('%') ||
            is_length(unit.substr(0, unit.find('/'))) || (unit.starts_with('m') && per_time));
}

/// The unit of a word: m/s2, or acc_m_s2. Empty if it has none.
std::string unit_of(std::string word)
{
    if (acceleration_unit(word) > 0.0 || is_odd_acceleration(word)) return word;
    const std::size_t end = word.find('_');
    if (end == std::string::npos) return {};
    word.erase(0, end + 1);
    std::ranges::replace(word, '_', '/');
    return unit_of(std::move(word));
}

/// The texts in the brackets of a line, without "in" or "units of".
std::vector<std::string_view> in_brackets(std::string_view line)
{
    std::vector<std::string_view> all;
    while (line.find_first_of("[(") != std::string_view::npos) {
        line.remove_prefix(line.find_first_of("[(") + 1);
        std::string_view text = stripped(line.substr(0, line.find_first_of("])")));
        for (const std::string_view key : {"in ", "unit: ", "units: ", "units ", "of "})
            if (lower(text).starts_with(key)) text = stripped(text.substr(key.size()));
        if (!text.empty()) all.push_back(text);
    }
    return all;
}

/// Adds a unit that is not there yet, under this or another spelling.
void add_unit(std::vector<std::string>& units, std::string unit)
{
    const double factor = acceleration_unit(unit);
    if (std::ranges::any_of(units, [&](const std::string& other) {
            return other == unit || (factor > 0.0 && acceleration_unit(other) == factor);
        }))
        return;
    units.push_back(std::move(unit));
}

/// Adds the units that a line mentions, but no values such as 0.3 g.
/// @param columns the line names columns: acc_m_s2 states a unit too
void add_mentioned(std::vector<std::string>& units, std::string_view line, bool columns)
{
    const std::vector<std::string> words = words_of(line);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string unit = unit_of(words[i]);
        const bool plain = words[i].find('_') == std::string::npos;
        if (unit.empty() || !(columns || plain) || (unit == "G" && !columns)) continue;
        const std::size_t before = i > 1 && words[i - 1] == "of" ? 2 : 1;
        const std::string part = i < before ? std::string() : lower(words[i - before]);
        if (number_of(part)) continue;
        const bool of_part = part.ends_with('%') || part == "percent" || part == "milli";
        add_unit(units, of_part ? part + ' ' + unit : unit);
    }
}

HeadUnit doubted(std::size_t line, const std::string& why)
{
    return {{}, false, line, why + ", or give --acceleration-unit"};
}

HeadUnit odd(std::size_t line, std::string_view unit)
{
    return doubted(line, in_quotes(unit) +
                             " is no unit of acceleration; use g, m/s2, cm/s2, mm/s2 or g/10");
}

/// The unit if there is one, a doubt if there are several. A lone G beside others is the name
/// of a station or component.
HeadUnit the_one(std::vector<std::string> units, std::size_t line, bool alone)
{
    if (units.size() > 1) std::erase(units, "G");
    if (units.size() > 1)
        return doubted(line, "two units of acceleration, " + in_quotes(units[0]) + " and " +
                                 in_quotes(units[1]) +
                                 "; leave the one of the values, as in \"acc [cm/s2]\"");
    if (units.empty()) return {{}, false, line, {}};
    if (acceleration_unit(units[0]) == 0.0) return odd(line, units[0]);
    return {units[0], alone, line, {}};
}

/// @param columns the line names columns, and is not only the one next to the numbers
HeadUnit unit_of_names(std::string_view line, std::size_t index, bool columns)
{
    std::vector<std::string> alone, units;
    std::string_view other;
    for (const std::string_view text : in_brackets(line)) {
        if (is_odd_unit(text)) return odd(index, text);
        if (acceleration_unit(text) > 0.0)
            add_unit(alone, std::string(text));
        else if (!is_time(text))
            other = text;
    }
    if (!alone.empty()) return the_one(alone, index, true);
    if (columns && !other.empty()) return odd(index, other);
    add_mentioned(units, line, columns);
    return the_one(units, index, false);
}

} // namespace

std::vector<std::string> words_of(std::string_view text)
{
    text = stripped(text.substr(0, 400));
    if (text.starts_with('%')) text.remove_prefix(1); // elsewhere it is part of a unit: %g
    std::string line(text);
    std::ranges::replace_if(
        line,
        [](char c) {
            return std::string_view("[](),;:=#\t\"").find(c) != std::string_view::npos;
        },
        ' ');
    std::vector<std::string> words;
    std::string_view rest = line;
    while (!(rest = stripped(rest)).empty()) {
        words.emplace_back(rest.substr(0, rest.find(' ')));
        rest.remove_prefix(words.back().size());
    }
    return words;
}

bool names_columns(std::string_view line)
{
    const std::vector<std::string> words = words_of(lower(line));
    const std::vector<std::string_view> units = in_brackets(line);
    return !words.empty() &&
           (words.front().starts_with("time") || words.front() == "t" ||
            words.front().starts_with("t_") || (!units.empty() && is_time(units.front())));
}

HeadUnit unit_above(const RecordText& text, std::size_t lines)
{
    const auto said = [](const HeadUnit& u) { return !u.unit.empty() || !u.doubt.empty(); };
    for (std::size_t i = lines; i-- > 0;)
        if (names_columns(text.lines[i]))
            if (HeadUnit u = unit_of_names(text.lines[i], i, true); said(u)) return u;
    std::size_t next = lines;
    while (next > 0 && stripped(text.lines[next - 1]).empty()) --next;
    if (next > 0)
        if (HeadUnit u = unit_of_names(text.lines[next - 1], next - 1, false); said(u))
            return u;
    std::vector<std::string> units;
    std::size_t line = lines;
    for (std::size_t i = 0; i < lines; ++i) {
        const std::size_t before = units.size();
        add_mentioned(units, text.lines[i], false);
        if (units.size() > before) line = i;
    }
    return the_one(units, line, false);
}

void check_large(const RecordText& text, std::size_t line, const HeadUnit& head,
                 const std::vector<double>& values)
{
    constexpr double kMost = 4.0; // [g] hardly any record has more
    const bool written = !head.unit.empty();
    if (head.alone || (written && acceleration_unit(head.unit) != kGravity)) return;
    for (const double a : values)
        if (std::abs(a) > kMost)
            refuse(text, written ? head.line : line,
                   (written ? "the unit seems to be g" : std::string("no unit is written")) +
                       ", and the values are too large for g; write the unit above the "
                       "columns, such as \"time [s], acceleration [cm/s2]\", or give "
                       "--acceleration-unit");
}

} // namespace ground
