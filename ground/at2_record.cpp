#include "ground/record_head.hpp"
#include "ground/record_text.hpp"

#include <algorithm>

namespace ground {
namespace {

/// "UNITS OF G", "The units are (g)", or what the lines above the numbers say.
HeadUnit unit_in_head(const RecordText& text, std::size_t head)
{
    for (std::size_t i = 0; i <= head; ++i) {
        const std::string low = lower(text.lines[i].substr(0, 400));
        for (const std::string_view key : {"units of", "units are", "units:", "units ="}) {
            const std::size_t at = low.find(key);
            if (at == std::string::npos) continue;
            std::string unit(stripped(std::string_view(low).substr(at + key.size())));
            std::erase_if(unit, [](char c) { return c == '(' || c == ')'; });
            unit.resize(std::min(unit.size(), unit.find_first_of(" ,;\t")));
            while (unit.ends_with('.')) unit.pop_back();
            return {unit, !unit.empty(), i, {}};
        }
    }
    return unit_above(text, head + 1);
}

/// Refuses a head of a velocity or displacement.
void check_quantity(const RecordText& text, std::size_t head)
{
    for (std::size_t i = 0; i <= head; ++i) {
        const std::string low = lower(text.lines[i].substr(0, 400));
        for (const std::string_view word : {"velocity time ", "displacement time "})
            if (low.find(word) != std::string::npos)
                refuse(text, i,
                       "the values are no acceleration; give the record of the accelerations");
    }
}

/// Number of samples and time step [s] of a head. The old one is "4000  0.00500  NPTS, DT".
struct CountAndStep {
    std::optional<double> count, step;
    std::size_t line = 0; ///< index of the last line that states them
};
CountAndStep count_and_step(const RecordText& text)
{
    const std::size_t points = find_line(text, "NPTS");
    CountAndStep stated{number_after(text.lines[points], "NPTS"), {}, points};
    for (std::size_t i = 0; i < text.lines.size() && !stated.step; ++i) {
        if (i > points && all_numbers(text.lines[i])) break;
        stated.step = number_after(text.lines[i], "DT");
        if (stated.step) stated.line = std::max(i, points);
    }
    const auto all = fields(text.lines[points], 0);
    if (!stated.count && !stated.step && all.size() >= 2)
        return {number_of(all[0]), number_of(all[1]), points};
    return stated;
}

} // namespace

std::vector<Record> at2_records(const RecordText& text, const ReadOptions& options)
{
    const CountAndStep stated = count_and_step(text);
    const std::size_t head = stated.line;
    const std::size_t count = checked_count(text, head, stated.count);
    const double step = checked_step(text, head, stated.step);
    const HeadUnit said = unit_in_head(text, head);
    const std::string& unit = said.unit;
    const bool told = !options.unit.empty();
    if (!told && !said.doubt.empty()) refuse(text, said.line, said.doubt);
    if (unit.empty() && !told) check_quantity(text, head);
    Values read = read_values(text, head + 1, count, 0);
    for (std::size_t i = read.end; i < text.lines.size(); ++i)
        if (all_numbers(text.lines[i]))
            refuse(text, i,
                   "more than the " + std::to_string(count) + " values that line " +
                       std::to_string(head + 1) + " states; mend NPTS there");
    if (!told) check_large(text, head, said, read.values);
    Record r = record_of(text, options, "PEER AT2", unit.empty() ? "g" : unit, head + 1, step,
                         std::move(read.values));
    if (unit.empty() && !told)
        r.remarks.emplace_back("no unit is written: read in g, as AT2 is");
    return {r};
}

} // namespace ground
