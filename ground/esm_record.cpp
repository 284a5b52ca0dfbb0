#include "ground/record_text.hpp"

#include <optional>

namespace ground {
namespace {

std::string_view esm_value(const RecordText& text, std::size_t line)
{
    return stripped(text.lines[line].substr(text.lines[line].find(':') + 1));
}

std::size_t esm_line(const RecordText& text, std::string_view key, std::size_t end)
{
    for (std::size_t i = 0; i < end; ++i)
        if (text.lines[i].starts_with(key)) return i;
    refuse(text, 0, "no line " + std::string(key) + " in the head; get the file again");
}

} // namespace

std::vector<Record> esm_records(const RecordText& text, const ReadOptions& options)
{
    std::size_t head = 0; // lines "KEY: value"
    while (head < text.lines.size() && !all_numbers(text.lines[head])) ++head;
    const std::size_t kind = esm_line(text, "DATA_TYPE:", head);
    if (lower(esm_value(text, kind)) != "acceleration")
        refuse(text, kind,
               in_quotes(esm_value(text, kind)) +
                   " is no acceleration; give the file with ACC in its name");
    const std::size_t points = esm_line(text, "NDATA:", head),
                      steps = esm_line(text, "SAMPLING_INTERVAL_S:", head);
    const std::size_t units = esm_line(text, "UNITS:", head);
    const std::size_t count = checked_count(text, points, number_of(esm_value(text, points)));
    const double step = checked_step(text, steps, number_of(esm_value(text, steps)));
    if (const std::size_t at = find_line(text, "DURATION_S:", 0, head); at < head)
        check_duration(text, at, number_of(esm_value(text, at)), count, step);
    Values read = read_values(text, head, count, 0);
    for (std::size_t i = read.end; i < text.lines.size(); ++i)
        if (!stripped(text.lines[i]).empty())
            refuse(text, i,
                   "more than the " + std::to_string(count) +
                       " values of NDATA; mend NDATA in line " + std::to_string(points + 1));
    Record r = record_of(text, options, "ESM ASCII", esm_value(text, units), head, step,
                         std::move(read.values));
    if (const std::size_t at = find_line(text, "STREAM:", 0, head); at < head)
        r.component = std::string(esm_value(text, at).substr(0, 12));
    if (const std::size_t at = find_line(text, "PGA_CM/S^2:", 0, head);
        at < head && options.unit.empty())
        if (const auto stated = number_of(esm_value(text, at)))
            check_peak(text, at, r, *stated, acceleration_unit("cm/s2"));
    return {r};
}

} // namespace ground
