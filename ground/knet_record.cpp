#include "ground/record_text.hpp"

#include <cmath>
#include <filesystem>
#include <numeric>

namespace ground {
namespace {

/// Index of the line of the head that begins with a key. The head has 17 lines.
std::size_t knet_line(const RecordText& text, std::string_view key)
{
    constexpr std::size_t kHead = 17;
    const std::size_t at = find_line(text, key, 0, kHead);
    if (at == text.lines.size())
        refuse(text, 0,
               "the head has no line of " + in_quotes(key) + "; get the file again, as ASCII");
    return at;
}

/// "7845(gal)/8223790": the value of a count.
struct CountScale {
    double value = 0.0; ///< [unit]
    std::string_view unit;
};

CountScale scale_of(const RecordText& text, std::size_t line)
{
    const std::string_view all = text.lines[line];
    const std::size_t open = all.find('('), close = all.find(')');
    const auto range = number_after(all, "scale factor"), counts = number_after(all, "/");
    if (open == std::string_view::npos || close < open || !range || !counts || !(*counts > 0.0))
        refuse(text, line, "no scale; it is written as in \"Scale Factor 7845(gal)/8223790\"");
    return {*range / *counts, all.substr(open + 1, std::min(close, all.size()) - open - 1)};
}

/// Instruments count from a zero of their own: the mean of a record is taken off, as the stated
/// peak does.
double take_mean_off(std::vector<double>& values)
{
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    for (double& v : values) v -= mean;
    return mean;
}

} // namespace

/// ASCII of K-NET and KiK-net (NIED): 17 lines, then 8 counts a line.
std::vector<Record> knet_records(const RecordText& text, const ReadOptions& options)
{
    const std::size_t rate = knet_line(text, "Sampling Freq"),
                      time = knet_line(text, "Duration Time"),
                      factor = knet_line(text, "Scale Factor"),
                      peak = knet_line(text, "Max. Acc."), memo = knet_line(text, "Memo.");
    const auto frequency = number_after(text.lines[rate], "(Hz)"),
               duration = number_after(text.lines[time], "(s)");
    if (!frequency || !(*frequency > 0.0))
        refuse(text, rate, "no frequency; it is written as in \"Sampling Freq(Hz) 100Hz\"");
    if (!duration)
        refuse(text, time, "no duration; it is written as in \"Duration Time(s) 120\"");
    const double step = checked_step(text, rate, 1.0 / *frequency);
    const std::size_t count = checked_count(text, time, std::round(*duration / step));
    const CountScale scale = scale_of(text, factor);
    Values read = read_values(text, memo + 1, count, 0);
    for (std::size_t i = read.end; i < text.lines.size(); ++i)
        if (!stripped(text.lines[i]).empty())
            refuse(text, i,
                   "more than the " + std::to_string(count) +
                       " values of the duration in line " + std::to_string(time + 1) +
                       "; mend it");
    for (double& v : read.values) v *= scale.value;
    const double mean = take_mean_off(read.values);
    Record r = record_of(text, options, "K-NET ASCII", scale.unit, memo + 1, step,
                         std::move(read.values));
    // EW, NS and UD of a record differ by what stands behind the point.
    r.motion.name = std::filesystem::path(text.path).filename().string();
    r.remarks.push_back("the mean, " + shown(mean) + " " + r.unit +
                        ", was taken off; uncorrected otherwise");
    if (const std::size_t at = find_line(text, "Dir.", 0, memo); at < memo)
        r.component = std::string(stripped(text.lines[at].substr(4)).substr(0, 12));
    if (const auto stated = number_after(text.lines[peak], "(gal)");
        stated && options.unit.empty())
        check_peak(text, peak, r, *stated, acceleration_unit("gal"));
    return {r};
}

} // namespace ground
