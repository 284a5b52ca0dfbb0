#include "app/calibration/test_notes.hpp"

#include "app/calibration/test_columns.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace app {
namespace {

bool is_reading(std::string_view name, const std::vector<TestReading>& readings)
{
    return std::ranges::find(readings, name, &TestReading::name) != readings.end();
}

/// Nothing where no column has a name like this one.
std::string did_you_mean(std::string_view name)
{
    std::array<std::string_view, kTestHeads.size()> names;
    std::ranges::transform(kTestHeads, names.begin(), &TestHead::name);
    const std::string_view near = nearest_word(name, names);
    return near.empty() ? "" : "; did you mean " + in_quotes(near) + "?";
}

std::string note_at(const Csv& csv, int line, const std::string& what)
{
    return "note: " + csv.path + ":" + std::to_string(line) + ": " + what + "\n";
}

/// Rows that have the cells of an earlier row, the name of the wall among them.
std::string repeated_rows(const Csv& csv)
{
    std::string notes;
    for (auto row = csv.rows.begin(); row != csv.rows.end(); ++row) {
        const auto first = std::ranges::find(csv.rows.begin(), row, row->cells, &CsvRow::cells);
        if (first != row)
            notes += note_at(csv, row->line,
                             "is the same as line " + std::to_string(first->line) +
                                 ", and counts as a further test; remove it if it is none");
    }
    return notes;
}

} // namespace

std::string test_notes(const Csv& csv, double height, bool taught)
{
    const std::vector<TestReading> readings = test_readings(csv, height);
    std::string notes;
    for (const std::string& head : csv.head) {
        const std::string name = test_name(head);
        const auto known =
            std::ranges::find(kTestHeads, std::string_view(name), &TestHead::name);
        const bool reading = is_reading(name, readings);
        if (known == kTestHeads.end() && !reading)
            notes += note_at(csv, 1, in_quotes(head) + " is not read" + did_you_mean(name));
        if (!taught && (reading || (known != kTestHeads.end() && known->inputs_only)))
            notes += note_at(csv, 1,
                             in_quotes(head) +
                                 " has no effect on a factor, which compares peaks and drops; "
                                 "calibration.inputs learns from it");
    }
    return notes + repeated_rows(csv);
}

} // namespace app
