#include "ground/record_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace ground {
namespace {

constexpr std::size_t kMostSamples = 50'000'000;

char lower_char(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// NaN and infinities are numbers here; Fortran's 1.5D-03 is one.
std::optional<double> any_number(std::string_view text)
{
    text = stripped(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    if (text.empty() || text.starts_with('+')) return {};
    double x = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    if (const auto at = static_cast<std::size_t>(end - text.data()); at < text.size()) {
        if (at == 0 || (text[at] != 'D' && text[at] != 'd')) return {};
        std::string plain(text);
        plain[at] = 'E';
        return any_number(plain);
    }
    if (error == std::errc::result_out_of_range) { // 1E-320 is 0, 1E+320 none
        std::istringstream in{std::string(text)};
        in.imbue(std::locale::classic());
        in >> x;
        return std::abs(x) < 1.0 ? std::optional(0.0) : std::nullopt;
    }
    if (error != std::errc()) return {};
    return x;
}

/// Where the next number begins although nothing stands between: at a sign that is none of an
/// exponent.
std::size_t sign_in(std::string_view token)
{
    for (std::size_t i = 1; i < token.size(); ++i)
        if ((token[i] == '-' || token[i] == '+') &&
            (is_digit(token[i - 1]) || token[i - 1] == '.'))
            return i;
    return token.size();
}

/// Refuses values that stand for missing ones: -999 and the like, far from their neighbours.
/// @param line index of the first value
void check_missing(const RecordText& text, std::size_t line, const std::vector<double>& values)
{
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double a = values[i];
        if (a != -999.0 && a != -9999.0 && a != -99999.0) continue;
        const auto far = [&](double other) { return std::abs(other) < 0.5 * std::abs(a); };
        if ((i > 0 && far(values[i - 1])) || (i + 1 < values.size() && far(values[i + 1])))
            refuse(text, line,
                   "value " + std::to_string(i + 1) + " is " + shown(a) +
                       ", which stands for a missing one; fill the gap, or cut the record");
    }
}

} // namespace

std::string shown(double x)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(6);
    out << x;
    return out.str();
}

std::string_view stripped(std::string_view text)
{
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string lower(std::string_view text)
{
    std::string low(text);
    std::ranges::transform(low, low.begin(), lower_char);
    return low;
}

std::string in_quotes(std::string_view text)
{
    constexpr std::size_t kShown = 40;
    std::string shown_text(text.substr(0, kShown));
    for (char& c : shown_text)
        if (c < ' ' || c > '~') c = '?';
    return '"' + shown_text + (text.size() > kShown ? "...\"" : "\"");
}

RecordText lines_of(const std::string& path, std::string_view text)
{
    RecordText t{path, {}};
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const char line_end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(line_end), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        t.lines.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return t;
}

void refuse(const RecordText& text, std::size_t line, const std::string& why)
{
    throw RecordError(text.path, static_cast<int>(line) + 1, why);
}

std::optional<double> number_of(std::string_view text)
{
    const auto x = any_number(text);
    return x && std::isfinite(*x) ? x : std::nullopt;
}

std::optional<double> number_after(std::string_view line, std::string_view key)
{
    const std::string low = lower(line);
    const std::size_t at = low.find(lower(key));
    if (at == std::string::npos) return {};
    std::string_view rest = line.substr(at + key.size());
    while (!rest.empty() &&
           (is_blank(rest.front()) || rest.front() == '=' || rest.front() == ':'))
        rest.remove_prefix(1);
    std::size_t end = 0;
    while (end < rest.size() &&
           (is_digit(rest[end]) ||
            std::string_view(".+-eEdD").find(rest[end]) != std::string_view::npos))
        ++end;
    for (; end > 0; --end) // "SEC" may follow at once
        if (const auto x = number_of(rest.substr(0, end))) return x;
    return {};
}

std::size_t find_line(const RecordText& text, std::string_view word, std::size_t from,
                      std::size_t many)
{
    const std::string wanted = lower(word);
    const std::size_t end = std::min(text.lines.size(), from + many);
    for (std::size_t i = from; i < end; ++i)
        if (lower(text.lines[i].substr(0, 400)).find(wanted) != std::string::npos) return i;
    return text.lines.size();
}

std::vector<std::string_view> fields(std::string_view line, std::size_t width)
{
    std::vector<std::string_view> all;
    if (width > 0) {
        while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
        for (; !line.empty(); line.remove_prefix(std::min(width, line.size())))
            all.push_back(line.substr(0, width));
        return all;
    }
    const auto divides = [](char c) { return is_blank(c) || c == ',' || c == ';' || c == '"'; };
    while (!line.empty()) {
        if (divides(line.front())) {
            line.remove_prefix(1);
            continue;
        }
        std::size_t end = 0;
        while (end < line.size() && !divides(line[end])) ++end;
        std::string_view token = line.substr(0, end);
        line.remove_prefix(end);
        while (!token.empty()) {
            const std::size_t next = sign_in(token);
            all.push_back(token.substr(0, next));
            token.remove_prefix(next);
        }
    }
    return all;
}

bool all_numbers(std::string_view line)
{
    const auto all = fields(line, 0);
    return !all.empty() &&
           std::ranges::all_of(all, [](auto f) { return any_number(f).has_value(); });
}

Values read_values(const RecordText& text, std::size_t from, std::size_t count,
                   std::size_t width)
{
    Values read;
    std::size_t bytes = 0;
    for (std::size_t i = from; i < text.lines.size() && bytes < 2 * count; ++i)
        bytes += text.lines[i].size();
    read.values.reserve(std::min(count, bytes)); // no more than the file can hold
    std::size_t i = from;
    for (; i < text.lines.size() && read.values.size() < count; ++i)
        for (const std::string_view field : fields(text.lines[i], width)) {
            const auto x = any_number(field);
            if (!x && !read.values.empty() &&
                text.lines[i].find_first_of("0123456789") == std::string_view::npos)
                refuse(text, i,
                       "the values end after " + std::to_string(read.values.size()) + " of " +
                           std::to_string(count) +
                           "; the file is cut off, or its head is wrong: get it again");
            if (!x)
                refuse(text, i,
                       in_quotes(stripped(field)) +
                           " is no number; mend the value or the file's columns");
            if (!std::isfinite(*x))
                refuse(text, i,
                       in_quotes(stripped(field)) +
                           " is not finite; fill the gap, or cut the record before it");
            if (read.values.size() == count)
                refuse(text, i,
                       "more than the " + std::to_string(count) +
                           " values that the head states; mend the number of points");
            read.values.push_back(*x);
        }
    if (read.values.size() < count)
        refuse(text, text.lines.size() - 1,
               "the file ends after " + std::to_string(read.values.size()) + " of " +
                   std::to_string(count) + " values; it is cut off: get it again");
    read.end = i;
    return read;
}

std::size_t checked_count(const RecordText& text, std::size_t line, std::optional<double> count)
{
    if (!count)
        refuse(text, line, "no number of points; write it as in \"NPTS= 4000, DT= .005 SEC\"");
    if (!(*count >= 2.0) || *count > static_cast<double>(kMostSamples) ||
        *count != std::floor(*count))
        refuse(text, line,
               shown(*count) + " is no number of points; must be in [2, " +
                   std::to_string(kMostSamples) + "]");
    return static_cast<std::size_t>(*count);
}

double checked_step(const RecordText& text, std::size_t line, std::optional<double> step)
{
    constexpr double kLeast = 1e-5, kMost = 0.5; // where times are in ms, 1 is no second
    if (!step) refuse(text, line, "no time step; write it as in \"NPTS= 4000, DT= .005 SEC\"");
    if (!(*step >= kLeast && *step <= kMost))
        refuse(text, line,
               "a time step of " + shown(*step) +
                   " s is out of range; must be in [1e-05, 0.5] s; convert times in ms to s");
    return *step;
}

Record record_of(const RecordText& text, const ReadOptions& options, std::string_view format,
                 std::string_view unit, std::size_t line, double step,
                 std::vector<double> values)
{
    Record r;
    r.format = format;
    r.unit = options.unit.empty() ? std::string(stripped(unit)) : options.unit;
    const double factor = acceleration_unit(r.unit);
    if (factor == 0.0)
        refuse(text, line,
               in_quotes(r.unit) +
                   " is no unit of acceleration; use g, m/s2, cm/s2, mm/s2 or g/10");
    if (std::ranges::any_of(r.unit, [](char c) { return c < ' ' || c > '~'; }))
        r.unit = factor == 1.0 ? "m/s2" : factor == 1e-2 ? "cm/s2" : "mm/s2"; // no Latin-1
    if (!options.unit.empty() && acceleration_unit(unit) != factor)
        r.remarks.push_back("read in " + r.unit + " as told, where the file says " +
                            (unit.empty() ? "nothing" : std::string(stripped(unit))));
    check_missing(text, line, values);
    for (double& a : values) a *= factor;
    constexpr double kMostAcceleration = 100.0 * kGravity;
    for (const double a : values)
        if (!(std::abs(a) <= kMostAcceleration))
            refuse(text, line,
                   "an acceleration of " + shown(a / kGravity) +
                       " g is out of range; the unit is not " + r.unit +
                       ", or the values are no acceleration");
    r.motion = {std::filesystem::path(text.path).stem().string(), step, std::move(values)};
    r.line = static_cast<int>(line) + 1;
    return r;
}

void check_peak(const RecordText& text, std::size_t head, Record& record, double stated,
                double unit)
{
    double read = 0.0;
    for (const double a : record.motion.acceleration)
        read = std::abs(a) > std::abs(read) ? a : read;
    record.stated_peak = stated * unit;
    constexpr double kRelative = 5e-3;
    const double rounding = 6e-4 * std::max(unit, kGravity * 1e-3);
    if (std::abs(std::abs(read) - std::abs(stated * unit)) >
        kRelative * std::abs(read) + rounding)
        refuse(text, head,
               "the head states a peak of " + shown(stated * unit) +
                   " m/s2, but the values have " + shown(read) +
                   " m/s2; the unit or the columns are wrong, or the file was changed");
}

void check_duration(const RecordText& text, std::size_t head, std::optional<double> stated,
                    std::size_t count, double step, double tolerance)
{
    if (!stated) return;
    const double read = static_cast<double>(count - 1) * step;
    if (std::abs(*stated - read) > 2.0 * step + tolerance * read)
        refuse(text, head,
               "the head states a duration of " + shown(*stated) + " s, but the values have " +
                   shown(read) + " s; the time step is wrong, or the file was changed");
}

double common_step(const RecordText& text, const std::vector<double>& time,
                   const std::vector<std::size_t>& line, int decimals)
{
    const std::size_t n = time.size();
    if (n < 2)
        refuse(text, line.empty() ? 0 : line.back(),
               "one time alone; a record needs two samples or more");
    for (std::size_t i = 1; i < n; ++i)
        if (!(time[i] > time[i - 1]))
            refuse(text, line[i],
                   "the time " + shown(time[i]) + " s does not come after " +
                       shown(time[i - 1]) + " s; sort the rows, and keep one of each time");
    // Times are rounded: 0.000, 0.003, 0.005 are steps of 0.0025 s.
    const double rounding = 0.51 * std::pow(10.0, -decimals) + 1e-9 * std::abs(time.back());
    const double step = (time.back() - time.front()) / static_cast<double>(n - 1);
    bool equal = true;
    for (std::size_t i = 0; i < n && equal; ++i)
        equal =
            std::abs(time.front() + static_cast<double>(i) * step - time[i]) <= 2.0 * rounding;
    if (!equal) {
        std::vector<double> steps(n - 1);
        for (std::size_t i = 1; i < n; ++i) steps[i - 1] = time[i] - time[i - 1];
        std::vector<double> sorted = steps;
        std::ranges::nth_element(
            sorted, sorted.begin() + static_cast<std::ptrdiff_t>(n / 2 - (n > 2 ? 0 : 1)));
        const double usual = sorted[n / 2 - (n > 2 ? 0 : 1)];
        for (std::size_t i = 0; i + 1 < n; ++i)
            if (std::abs(steps[i] - usual) > 2.0 * rounding)
                refuse(text, line[i + 1],
                       "a step of " + shown(steps[i]) + " s before " + shown(time[i + 1]) +
                           " s, where " + shown(usual) +
                           " s is usual: a gap; fill it, or resample at equal steps");
        refuse(text, line.back(),
               "the time steps are not equal; resample the record at equal steps");
    }
    for (const double in_a_second : {1e4, 1e5, 1e6, 1e7}) { // as meant: 0.01, not 0.009999997
        const double meant = std::round(step * in_a_second) / in_a_second;
        if (std::abs(meant - step) * static_cast<double>(n - 1) <= 2.0 * rounding) return meant;
    }
    return step;
}

} // namespace ground
