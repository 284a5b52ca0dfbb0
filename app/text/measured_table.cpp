#include "app/text/measured_table.hpp"

#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace app {
namespace {

constexpr std::string_view kBetweenWords = " _[](),/";
constexpr std::string_view kSeparators = ",;\t";

/// The words of a head before its last one, and the last one.
std::pair<std::string, std::string> split_head(std::string_view head)
{
    head = head.substr(0, head.find_last_not_of(kBetweenWords) + 1);
    const std::size_t unit = head.find_last_of(kBetweenWords) + 1;
    const std::size_t end = head.substr(0, unit).find_last_not_of(kBetweenWords) + 1;
    return {lower_case(head.substr(0, end)), lower_case(head.substr(unit))};
}

/// Two cells or more of digits, dates and times.
bool is_of_numbers(std::string_view line)
{
    return line.find_first_not_of("0123456789+-.,;:/eE \t\"\r") == std::string_view::npos &&
           line.find_first_of("0123456789") != std::string_view::npos &&
           line.find_first_of(kSeparators) != std::string_view::npos;
}

bool is_one_of(std::span<const MeasuredUnit> units, std::string_view name)
{
    return std::ranges::count(units, name, &MeasuredUnit::name) > 0;
}

bool is_of_units(std::string_view line)
{
    bool length = false, force = false;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.size(), line.find_first_of(kSeparators, at));
        std::string_view cell = trimmed(line.substr(at, end - at));
        if (cell.size() > 1 && cell.front() == '"') cell = cell.substr(1, cell.size() - 2);
        const auto [words, unit] = split_head(cell);
        length = length || (words.empty() && is_one_of(kMeasuredLengths, unit));
        force = force || (words.empty() && is_one_of(kMeasuredForces, unit));
        at = end + 1;
    }
    return length && force;
}

/// A line that is not empty.
struct Line {
    std::size_t at = 0;
    int number = 1; ///< from 1
    std::string_view text;
};

/// Lines before the first one of numbers.
std::vector<Line> lines_before_numbers(const std::string& path, std::string_view text)
{
    std::vector<Line> lines;
    int number = 1;
    for (std::size_t at = 0; at < text.size(); ++number) {
        const std::size_t end = std::min(text.size(), text.find('\n', at));
        const std::string_view line = trimmed(text.substr(at, end - at));
        if (is_of_numbers(line)) {
            if (!lines.empty()) return lines;
            throw ConfigError(path, number, "",
                              "has no head above its numbers; write one, such as "
                              "\"displacement_mm,force_kN\"");
        }
        if (!line.empty()) lines.push_back({at, number, line});
        at = end + 1;
    }
    return {}; // no numbers: the first line is the head
}

} // namespace

std::string unit_of(std::string_view head)
{
    auto [words, unit] = split_head(head);
    return words.empty() && unit.size() == 1 ? "" : unit; // "n" is a name
}

std::string quantity_of(std::string_view head) { return split_head(head).first; }

MeasuredTable measured_table(const std::string& path, std::string text)
{
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw ConfigError(path, 0, "", "is text in UTF-16; save it as UTF-8");
    text = plain_text(std::move(text));
    MeasuredTable table;
    const std::vector<Line> lines = lines_before_numbers(path, text);
    const bool units = lines.size() > 1 && is_of_units(lines.back().text) &&
                       !lines[lines.size() - 2].text.starts_with("sep=");
    if (lines.size() > (units ? 2U : 1U) && !text.starts_with("sep=")) {
        const Line& head = lines[lines.size() - (units ? 2 : 1)];
        table.line = head.number;
        text.replace(0, head.at, std::string(static_cast<std::size_t>(head.number - 1), '\n'));
    }
    table.csv = parse_csv(path, text);
    if (units) {
        for (std::size_t i = 0; i < table.csv.head.size(); ++i)
            table.csv.head[i] += " " + table.csv.rows.front().cells[i];
        table.csv.rows.erase(table.csv.rows.begin());
    }
    return table;
}

} // namespace app
