#include "ground/record_head.hpp"
#include "ground/record_text.hpp"

namespace ground {
namespace {

/// "UNITS OF G", "The units are (g)", or a unit alone; empty if no line of the head says it.
std::string unit_in_head(const RecordText& text, std::size_t head)
{
    for (std::size_t i = 0; i <= head; ++i) {
        const std::string low = lower(text.lines[i].substr(0, 400));
        for (const std::string_view key : {"units of", "units are", "units:", "units ="}) {
            const std::size_t at = low.find(key);
            if (at == std::string::npos) continue;
            std::string unit(stripped(std::string_view(low).substr(at + key.size())));
            std::erase_if(unit, [](char c) { return c == '(' || c == ')'; });
            return unit.substr(0, unit.find_first_of(" ,;\t"));
        }
    }
    return unit_above(text, head + 1);
}

/// The old head: "4000  0.00500  NPTS, DT".
struct CountAndStep {
    std::optional<double> count, step;
};
CountAndStep old_head(std::string_view line)
{
    const auto all = fields(line, 0);
    if (all.size() < 2) return {};
    return {number_of(all[0]), number_of(all[1])};
}

} // namespace

std::vector<Record> at2_records(const RecordText& text, const ReadOptions& options)
{
    const std::size_t head = find_line(text, "NPTS");
    CountAndStep stated{number_after(text.lines[head], "NPTS"),
                        number_after(text.lines[head], "DT")};
    if (!stated.count && !stated.step) stated = old_head(text.lines[head]);
    const std::size_t count = checked_count(text, head, stated.count);
    const double step = checked_step(text, head, stated.step);
    const std::string unit = unit_in_head(text, head);
    Values read = read_values(text, head + 1, count, 0);
    for (std::size_t i = read.end; i < text.lines.size(); ++i)
        if (all_numbers(text.lines[i]))
            refuse(text, i,
                   "more than the " + std::to_string(count) + " values that line " +
                       std::to_string(head + 1) + " states; mend NPTS there");
    if (unit.empty() && options.unit.empty()) check_unsaid(text, head, read.values);
    Record r = record_of(text, options, "PEER AT2", unit.empty() ? "g" : unit, head + 1, step,
                         std::move(read.values));
    if (unit.empty() && options.unit.empty())
        r.remarks.emplace_back("no unit is written: read in g, as AT2 is");
    return {r};
}

} // namespace ground
