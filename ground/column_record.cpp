#include "ground/record_head.hpp"
#include "ground/record_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace ground {
namespace {

/// The unit of the first column: ms of "time [ms]", "Zeit (ms)" or "time_ms".
std::string first_unit(std::string_view names)
{
    const std::vector<std::string> words = words_of(names);
    if (words.empty()) return {};
    const std::string& name = words.front();
    if (const std::size_t at = name.find('_'); at != std::string::npos)
        return name.substr(at + 1);
    return words.size() > 1 ? words[1] : std::string();
}

/// Whether a row has two numbers once its commas are points.
bool decimal_commas(std::string_view row)
{
    std::string points(row);
    std::ranges::replace(points, ',', '.');
    return points != row && fields(points, 0).size() == 2 && all_numbers(points);
}

/// Refuses a row that has not two numbers.
void check_row(const RecordText& text, std::size_t line)
{
    const std::string_view row = text.lines[line];
    const auto cells = fields(row, 0);
    if (cells.size() != 2 && decimal_commas(row))
        refuse(text, line, "decimal commas; write points, as in \"0.005; 1.23\"");
    if (cells.size() != 2)
        refuse(text, line,
               std::to_string(cells.size()) + (cells.size() == 1 ? " value" : " values") +
                   " in place of two; mend the row");
    for (const std::string_view cell : cells)
        if (!number_of(cell))
            refuse(text, line,
                   in_quotes(cell) +
                       " is no finite number; fill the gap, or cut the record there");
}

/// Whether a line states a unit of velocity or length; a lone m or in may be another word.
bool states_motion(std::string_view line)
{
    constexpr std::array<std::string_view, 8> kUnits = {"cm/s",  "m/s",    "mm/s", "cm/sec",
                                                        "m/sec", "mm/sec", "cm",   "mm"};
    return std::ranges::any_of(words_of(line), [&](const std::string& word) {
        return std::ranges::find(kUnits, word) != kUnits.end();
    });
}

/// Refuses columns whose names say that they are not time [s] and an acceleration.
/// @param known a unit of acceleration is told or written
void check_names(const RecordText& text, std::size_t first, bool known)
{
    std::size_t head = first;
    while (head > 0 && stripped(text.lines[head - 1]).empty()) --head;
    if (head-- == 0) return;
    const std::string names = lower(text.lines[head]);
    const bool columns = names_columns(names);
    const auto have = [&](std::string_view word) {
        return names.find(word) != std::string::npos;
    };
    for (const std::string word : {"ms", "msec", "milliseconds", "min"})
        if ((columns && first_unit(names) == word) || have('[' + word + ']') ||
            have('(' + word + ')'))
            refuse(text, head, "the times are in " + word + "; convert them to s");
    const bool other = (have("velocity") || have("displacement")) && !have("acc");
    if (!columns && !(other && states_motion(names)))
        return; // a title, which may say anything else
    if (!known && other)
        refuse(text, head,
               "the values are no acceleration; give the record of the accelerations");
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
    if (columns != 2 && !decimal_commas(text.lines[first]))
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
        check_row(text, i);
        const auto cells = fields(text.lines[i], 0);
        time.push_back(*number_of(cells[0]));
        values.push_back(*number_of(cells[1]));
        line.push_back(i);
        decimals = std::max(decimals, decimals_of(cells[0]));
    }
    const auto grows = [](const std::vector<double>& x) {
        return std::ranges::adjacent_find(x, std::greater_equal()) == x.end();
    };
    if (grows(values) && !grows(time))
        refuse(text, first,
               "the second column grows as a time does, and the first does not; write time [s] "
               "first, then the acceleration");
    const HeadUnit head = unit_above(text, first);
    const std::string& unit = head.unit;
    const bool told = !options.unit.empty();
    check_names(text, first, told || !unit.empty());
    if (!told && !head.doubt.empty()) refuse(text, head.line, head.doubt);
    const double step = checked_step(text, first, common_step(text, time, line, decimals));
    if (!told) check_large(text, first, head, values);
    Record r = record_of(text, options, "two columns", unit.empty() ? "g" : unit, first, step,
                         std::move(values));
    if (unit.empty() && !told) r.remarks.emplace_back("no unit is written: read in g");
    if (time.front() != 0.0)
        r.remarks.emplace_back("the times of the file do not begin at 0; here they do");
    return {r};
}

} // namespace ground
