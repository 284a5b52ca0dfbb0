/// Volumes of the Californian and other networks: V1 (pairs of time and value), V2, V2A,
/// COSMOS, and a text of the USGS.

#include "ground/record_text.hpp"

#include <algorithm>
#include <cmath>

namespace ground {
namespace {

/// Behind the last "UNITS:" or "in ", such as "(UNITS: CM/SEC/SEC)" or "in cm/sec2. (8f10.6)".
std::string unit_in(std::string_view line)
{
    const std::string low = lower(line);
    for (const std::string_view key : {"units:", "units=", " in "}) {
        const std::size_t at = low.rfind(key);
        if (at == std::string::npos) continue;
        const std::string_view rest = stripped(std::string_view(low).substr(at + key.size()));
        std::string unit(rest.substr(0, rest.find_first_of("() ,;")));
        while (unit.ends_with('.')) unit.pop_back();
        return unit;
    }
    return {};
}

std::string component_in(std::string_view line)
{
    const std::size_t at = line.find(':');
    std::string_view name = at == std::string_view::npos ? line : line.substr(at + 1);
    name = stripped(name.substr(0, name.find("(")));
    return std::string(name.substr(0, 12));
}

/// A number of points before the word, and the step behind "spaced at".
struct Block {
    std::size_t line = 0, count = 0;
    double step = 0.0;
};

/// Refuses a step that is not the one above the block, or does not make the duration there. The
/// record as it came may be longer than what was corrected.
void check_head_step(const RecordText& text, std::size_t from, std::size_t at,
                     std::size_t count, double step)
{
    if (const std::size_t line = find_line(text, "intervals of", from, at - from); line < at)
        if (const auto other = number_after(text.lines[line], "intervals of");
            other && std::abs(*other - step) > 1e-3 * step)
            refuse(text, line,
                   "a time step of " + shown(*other) + " s, where line " +
                       std::to_string(at + 1) + " has " + shown(step) +
                       " s; mend the one that is wrong");
    constexpr double kCorrected = 0.1;
    for (const std::string_view key : {"record length", "duration"})
        if (const std::size_t line = find_line(text, key, from, at - from); line < at)
            check_duration(text, line, number_after(text.lines[line], key), count, step,
                           kCorrected);
}

} // namespace

std::vector<Record> v2_records(const RecordText& text, const ReadOptions& options)
{
    constexpr std::size_t kWidth = 10;
    std::vector<Record> all;
    std::size_t from = 0;
    for (;;) {
        const std::size_t at = find_line(text, "points of acc", from, text.lines.size());
        if (at >= text.lines.size()) break;
        const std::string_view line = text.lines[at];
        const auto first = fields(line, 0);
        Block b{at, checked_count(text, at, number_of(first.front())),
                checked_step(text, at, number_after(line, "spaced at"))};
        check_head_step(text, from, at, b.count, b.step);
        Values read = read_values(text, at + 1, b.count, kWidth);
        const std::size_t peak = find_line(text, "peak acceleration", from, at - from);
        const bool usc =
            peak < at && lower(text.lines[peak]).find("cms/sec/sec") != std::string::npos;
        std::string unit = unit_in(line);
        if (unit.empty() && usc) unit = "cm/s2";
        if (unit.empty() && options.unit.empty())
            refuse(text, at,
                   "no unit of the acceleration; write it as in \"(UNITS: CM/SEC/SEC)\", or "
                   "give --acceleration-unit");
        Record r = record_of(text, options, usc ? "USC V2" : "CSMIP V2", unit, at + 1, b.step,
                             std::move(read.values));
        for (std::size_t i = from; i < at; ++i)
            if (lower(text.lines[i].substr(0, 5)) == "chan ")
                r.component = component_in(text.lines[i]);
        if (peak < at && options.unit.empty())
            if (const auto stated = number_after(text.lines[peak], "acceleration"))
                check_peak(text, peak, r, *stated, acceleration_unit("cm/s2"));
        all.push_back(std::move(r));
        from = read.end;
    }
    return all;
}

std::vector<Record> v1_records(const RecordText& text, const ReadOptions& options)
{
    constexpr std::size_t kHead = 27, kPairs = 5;
    std::vector<Record> all;
    std::size_t from = 0;
    while (from + kHead < text.lines.size() &&
           lower(text.lines[from]).find("uncorrected accelerogram") != std::string::npos) {
        const std::size_t points = find_line(text, "no. of points", from, kHead);
        const std::size_t units = find_line(text, "units of uncor", from, kHead);
        if (points >= text.lines.size())
            refuse(text, from, "no line \"NO. OF POINTS =\" in this head; get the file again");
        if (units >= text.lines.size())
            refuse(text, from,
                   "no line \"UNITS OF UNCOR ACCEL ARE\" in this head; get the file again");
        const std::size_t count =
            checked_count(text, points, number_after(text.lines[points], "points"));
        const std::size_t first = from + kHead;
        const std::string_view line = text.lines[first];
        const std::size_t end = line.find_last_not_of(" \t") + 1; // blanks may pad it
        const std::size_t width = end % (2 * kPairs) == 0 ? end / (2 * kPairs) : 0;
        const Values read = read_values(text, first, 2 * count, width);
        std::vector<double> time(count), values(count);
        std::vector<std::size_t> where(count);
        for (std::size_t i = 0; i < count; ++i) {
            time[i] = read.values[2 * i];
            values[i] = read.values[2 * i + 1];
            where[i] = first + i / kPairs;
        }
        const std::string low = lower(text.lines[units]);
        std::string unit = low.find("g/10") != std::string::npos ? "g/10" : "";
        if (unit.empty() && options.unit.empty())
            refuse(text, units,
                   "the unit is not g/10; write it so, or give --acceleration-unit");
        constexpr int kDecimals = 3;
        const double step =
            checked_step(text, first, common_step(text, time, where, kDecimals));
        check_duration(text, points, number_after(text.lines[points], "record length"), count,
                       step);
        Record r = record_of(text, options, "CSMIP V1", unit, first, step, std::move(values));
        r.remarks.emplace_back("uncorrected: with its offset and the instrument in it");
        if (const std::size_t name = find_line(text, "chan ", from, kHead);
            name < text.lines.size())
            r.component = component_in(text.lines[name]);
        if (const auto stated = number_after(text.lines[units], "max");
            stated && options.unit.empty())
            check_peak(text, units, r, *stated, kGravity);
        all.push_back(std::move(r));
        from = read.end;
        while (from < text.lines.size() &&
               (text.lines[from].starts_with("/&") || stripped(text.lines[from]).empty()))
            ++from;
    }
    return all;
}

std::vector<Record> v2a_records(const RecordText& text, const ReadOptions& options)
{
    constexpr std::size_t kHead = 26, kWidth = 8, kPerLine = 10, kCounts = 20;
    std::vector<Record> all;
    std::size_t from = 0;
    while (from < text.lines.size() &&
           lower(text.lines[from]).find("corrected accelerogram") != std::string::npos) {
        if (from + kHead >= text.lines.size())
            refuse(text, from, "the head ends before its 26 lines; get the file again");
        const std::size_t points = find_line(text, "number of points", from, kHead);
        const std::size_t steps = find_line(text, "data at", from, kHead);
        const std::size_t peak = find_line(text, "acceleration:", from, kHead);
        if (points >= text.lines.size() || steps >= text.lines.size() ||
            peak >= text.lines.size())
            refuse(
                text, from,
                "the head lacks its number of points, time step or peak; get the file again");
        const std::size_t count =
            checked_count(text, points, number_after(text.lines[points], "points"));
        const double step =
            checked_step(text, steps, number_after(text.lines[steps], "data at"));
        check_duration(text, points, number_after(text.lines[points], "duration"), count, step);
        const std::string low = lower(text.lines[peak]);
        const std::string unit = low.find("mm/s/s") != std::string::npos ? "mm/s2" : "";
        if (unit.empty() && options.unit.empty())
            refuse(text, peak,
                   "the unit is not mm/s/s; write it so, or give --acceleration-unit");
        Values read = read_values(text, from + kHead, count, kWidth);
        Record r = record_of(text, options, "GeoNet V2A", unit, from + kHead, step,
                             std::move(read.values));
        if (const std::size_t name = find_line(text, "component", from, kHead);
            name < text.lines.size()) {
            const std::string_view words =
                stripped(text.lines[name].substr(std::string_view("component").size()));
            r.component = std::string(words.substr(0, words.find(' ')).substr(0, 12));
        }
        if (const auto stated = number_after(low, "peak"); stated && options.unit.empty())
            check_peak(text, peak, r, *stated, acceleration_unit("mm/s2"));
        all.push_back(std::move(r));
        from = read.end; // velocity and displacement follow, with numbers of their own
        const auto counts =
            fields(text.lines[all.back().line - 1 - kHead + kCounts - 1], kWidth);
        for (std::size_t i = 4; i < 6 && i < counts.size(); ++i) {
            const auto n = number_of(counts[i]);
            if (n && *n > 0.0 && *n <= 1e8)
                from += (static_cast<std::size_t>(*n) + kPerLine - 1) / kPerLine;
        }
        while (from < text.lines.size() && stripped(text.lines[from]).empty()) ++from;
        if (from < text.lines.size() &&
            lower(text.lines[from]).find("corrected accelerogram") == std::string::npos)
            refuse(text, from, "the head of a component is wanted here; get the file again");
    }
    return all;
}

std::vector<Record> cosmos_records(const RecordText& text, const ReadOptions& options)
{
    std::vector<Record> all;
    std::size_t from = 0;
    for (;;) {
        const std::size_t at = find_line(text, "acceleration pts", from, text.lines.size());
        if (at >= text.lines.size()) break;
        const std::size_t reals = find_line(text, "real-header values", from, at - from);
        if (reals >= at)
            refuse(text, at, "no line \"Real-header values\" above; get the file again");
        constexpr std::size_t kInterval = 61; // value 62: sampling interval [ms]
        const Values head = read_values(text, reals + 1, 5 * 20, 15);
        const double step =
            checked_step(text, reals + 1 + kInterval / 5, head.values[kInterval] * 1e-3);
        const std::size_t count =
            checked_count(text, at, number_of(fields(text.lines[at], 0).front()));
        Values read = read_values(text, at + 1, count, 0);
        Record r = record_of(text, options, "COSMOS V2c", unit_in(text.lines[at]), at + 1, step,
                             std::move(read.values));
        if (const std::size_t max = find_line(text, "max =", from, at - from);
            max < at && options.unit.empty()) {
            const std::size_t last = find_line(text, "cm/sec2", from, at - from);
            const std::string low = lower(text.lines[last < at ? last : max]);
            const std::size_t place = low.rfind("max =");
            if (place != std::string::npos)
                if (const auto stated =
                        number_after(std::string_view(low).substr(place), "max ="))
                    check_peak(text, last, r, *stated, acceleration_unit("cm/s2"));
        }
        all.push_back(std::move(r));
        from = read.end;
    }
    return all;
}

std::vector<Record> usgs_records(const RecordText& text, const ReadOptions& options)
{
    const std::size_t rate = find_line(text, "samples/sec");
    const std::size_t points = find_line(text, "no of points", rate, 3);
    if (points >= text.lines.size())
        refuse(text, rate, "no line \"NO OF POINTS=\" below; get the file again");
    if (lower(text.lines[rate]).find("data type=ac") == std::string::npos)
        refuse(text, rate, "these values are no acceleration; give the file with DATA TYPE=AC");
    const auto per_second = number_after(text.lines[rate], "samples/sec");
    const double step =
        checked_step(text, rate, per_second ? std::optional(1.0 / *per_second) : std::nullopt);
    const std::size_t count =
        checked_count(text, points, number_after(text.lines[points], "points"));
    Values read = read_values(text, points + 1, count, 8);
    Record r = record_of(text, options, "USGS text", unit_in(text.lines[points]), points + 1,
                         step, std::move(read.values));
    if (const auto component =
            number_after(text.lines[find_line(text, "component")], "component"))
        r.component = std::to_string(static_cast<int>(std::clamp(*component, -1e6, 1e6)));
    return {r};
}

} // namespace ground
