#include "ground/record_text.hpp"

namespace ground {

std::vector<Record> smc_records(const RecordText& text, const ReadOptions& options)
{
    // 11 lines of text, 6 of 8 whole numbers, 10 of 5 reals, comments, values in fields of 10.
    constexpr std::size_t kText = 11, kWholes = 48, kReals = 50, kWidth = 10;
    constexpr std::size_t kComments = 15, kPoints = 16, kRate = 1;
    const std::string_view kind = stripped(text.lines[0]);
    if (!kind.starts_with('1') && !kind.starts_with('2'))
        refuse(text, 0,
               in_quotes(kind) + " is no acceleration; give the file that begins with 1 or 2");
    if (text.lines.size() <= kText + 16)
        refuse(text, text.lines.size() - 1,
               "the head ends before its 27 lines; get the file again");
    const Values wholes = read_values(text, kText, kWholes, 10);
    const Values reals = read_values(text, wholes.end, kReals, 15);
    const double comments = wholes.values[kComments];
    if (!(comments >= 0.0 && comments < 1000.0))
        refuse(text, kText + 1, "no number of comment lines; get the file again");
    const std::size_t count = checked_count(text, kText + 2, wholes.values[kPoints]);
    const double rate = reals.values[kRate];
    const double step =
        checked_step(text, wholes.end, rate > 0.0 ? std::optional(1.0 / rate) : std::nullopt);
    std::size_t first = reals.end + static_cast<std::size_t>(comments);
    Values read = read_values(text, first, count, kWidth);
    Record r =
        record_of(text, options, "USGS SMC", "cm/s2", first, step, std::move(read.values));
    if (kind.starts_with('1'))
        r.remarks.emplace_back("uncorrected: with its offset and the instrument in it");
    if (const std::size_t at = find_line(text, "component=", 0, kText); at < kText)
        if (const auto degrees = number_after(text.lines[at], "component=")) {
            const std::string_view line = stripped(text.lines[at]);
            r.component = std::string(stripped(line.substr(line.rfind('=') + 1)).substr(0, 12));
        }
    if (const std::size_t at = find_line(text, "pk ", 0, kText);
        at < kText && options.unit.empty())
        if (const auto stated = number_after(text.lines[at], "pk "))
            check_peak(text, at, r, *stated, acceleration_unit("cm/s2"));
    return {r};
}

} // namespace ground
