#include "ground/record_text.hpp"

#include <algorithm>
#include <cmath>

namespace ground {
namespace {

/// The last word of the lines above the numbers that is a unit of acceleration.
std::string unit_above(const RecordText& text, std::size_t first)
{
    std::string unit;
    for (std::size_t i = 0; i < first; ++i) {
        std::string line(text.lines[i].substr(0, 400));
        std::ranges::replace_if(
            line,
            [](char c) {
                return std::string_view("[](),;:=#%\t\"").find(c) != std::string_view::npos;
            },
            ' ');
        std::string_view rest = line;
        while (!(rest = stripped(rest)).empty()) {
            const std::string_view word = rest.substr(0, rest.find(' '));
            if (acceleration_unit(word) > 0.0) unit = word;
            rest.remove_prefix(word.size());
        }
    }
    return unit;
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
    if (columns != 2)
        refuse(text, first,
               std::to_string(columns) +
                   " columns, where time [s] and one acceleration are wanted; keep two");
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
    const double step = checked_step(text, first, common_step(text, time, line, decimals));
    const std::string unit = unit_above(text, first);
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
