#include "ground/record_text.hpp"

#include <algorithm>
#include <cmath>

namespace ground {
namespace {

/// Words of a line, without brackets and separators.
std::vector<std::string> words_of(std::string_view text)
{
    std::string line(text.substr(0, 400));
    std::ranges::replace_if(
        line,
        [](char c) {
            return std::string_view("[](),;:=#%\t\"").find(c) != std::string_view::npos;
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

/// The last word of the lines above the numbers that is a unit of acceleration.
std::string unit_above(const RecordText& text, std::size_t first)
{
    std::string unit;
    for (std::size_t i = 0; i < first; ++i)
        for (std::string& word : words_of(text.lines[i]))
            if (acceleration_unit(word) > 0.0) unit = std::move(word);
    return unit;
}

/// The text in the last brackets of a line: the unit of its last column. Empty if it has none.
std::string_view last_in_brackets(std::string_view line)
{
    const std::size_t end = line.find_last_of("])");
    if (end == std::string_view::npos) return {};
    const std::size_t begin = line.find_last_of("[(", end);
    if (begin == std::string_view::npos) return {};
    return stripped(line.substr(begin + 1, end - begin - 1));
}

bool is_unit_of_time(std::string_view text)
{
    const std::string unit = lower(text);
    return unit == "s" || unit.starts_with("sec");
}

/// Refuses columns whose names say that they are not time [s] and an acceleration in a unit
/// that is known here.
void check_names(const RecordText& text, std::size_t first, const std::string& unit)
{
    std::size_t head = first;
    while (head > 0 && stripped(text.lines[head - 1]).empty()) --head;
    if (head-- == 0) return;
    const std::string names = lower(text.lines[head]);
    const std::vector<std::string> words = words_of(names);
    if (words.empty() || !(words.front().starts_with("time") || words.front() == "t"))
        return; // a title, which may say anything
    const auto have = [&](std::string_view word) {
        return names.find(word) != std::string::npos;
    };
    if (unit.empty() && (have("velocity") || have("displacement")) && !have("acc"))
        refuse(text, head,
               "the values are no acceleration; give the record of the accelerations");
    for (const std::string_view word : {"ms", "msec", "milliseconds", "min"})
        if (words.size() > 1 && words[1] == word)
            refuse(text, head, "the times are in " + words[1] + "; convert them to s");
    const std::string_view last = last_in_brackets(text.lines[head]);
    if (unit.empty() && !last.empty() && !is_unit_of_time(last))
        refuse(text, head,
               in_quotes(last) + " is no unit of acceleration; use g, m/s2, cm/s2, mm/s2 or "
                                 "g/10, or give --acceleration-unit");
}

int decimals_of(std::string_view number)
{
    const std::size_t point = number.find('.');
    if (point == std::string_view::npos)
        return number.find_first_of("eE") == std::string_view::npos ? 0 : 9;
    const std::size_t e = number.find_first_of("eE");
    const int digits = static_cast<int>(std::min(e, number.size()) - point) - 1;
    return e == std::string_view::npos ? digits : 9;
}

} // namespace

std::vector<Record> column_records(const RecordText& text, const ReadOptions& options)
{
    std::size_t first = 0;
    while (first < text.lines.size() && !all_numbers(text.lines[first])) ++first;
    const std::size_t columns = fields(text.lines[first], 0).size();
    if (columns == 1)
        refuse(text, first,
               "one column and no time step; write two columns, time [s] and acceleration, or "
               "put a line such as "
               "\"NPTS= 4000, DT= .005 SEC\" above");
    const std::string_view row = text.lines[first];
    if (columns != 2 && row.find(';') != std::string_view::npos &&
        row.find(',') != std::string_view::npos)
        refuse(text, first, "decimal commas; write points, as in \"0.005; 1.23\"");
    if (columns != 2)
        refuse(text, first,
               std::to_string(columns) +
                   " columns, where time [s] and one acceleration are wanted; keep two, or, "
                   "where accelerations run on from line to line, put a line such as "
                   "\"NPTS= 4000, DT= .005 SEC\" above");
    std::vector<double> time, values;
    std::vector<std::size_t> line;
    int decimals = 0;
    for (std::size_t i = first; i < text.lines.size(); ++i) {
        if (stripped(text.lines[i]).empty()) continue;
        const auto cells = fields(text.lines[i], 0);
        if (cells.size() != 2)
            refuse(text, i,
                   std::to_string(cells.size()) + " values in place of two; mend the row");
        for (const std::string_view cell : cells)
            if (!number_of(cell))
                refuse(text, i,
                       in_quotes(cell) +
                           " is no finite number; fill the gap, or cut the record there");
        time.push_back(*number_of(cells[0]));
        values.push_back(*number_of(cells[1]));
        line.push_back(i);
        decimals = std::max(decimals, decimals_of(cells[0]));
    }
    const std::string unit = unit_above(text, first);
    check_names(text, first, unit.empty() ? options.unit : unit);
    const double step = checked_step(text, first, common_step(text, time, line, decimals));
    double peak = 0.0;
    for (const double a : values) peak = std::max(peak, std::abs(a));
    constexpr double kMostUnsaid = 4.0; // [g] hardly any record has more
    if (unit.empty() && options.unit.empty() && peak > kMostUnsaid)
        refuse(text, first,
               "no unit is written, and the values are too large for g; write it above the "
               "columns, such as "
               "\"time [s], acceleration [cm/s2]\", or give --acceleration-unit");
    Record r = record_of(text, options, "two columns", unit.empty() ? "g" : unit, first, step,
                         std::move(values));
    if (unit.empty() && options.unit.empty())
        r.remarks.emplace_back("no unit is written: read in g");
    if (time.front() != 0.0)
        r.remarks.emplace_back("the times of the file do not begin at 0; here they do");
    return {r};
}

} // namespace ground
