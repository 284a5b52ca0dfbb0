#include "app/output/picture/chart_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr double kMargin = kChartMargin, kTickSize = 12.0; // [px]

struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value, bool log)
    {
        if (!std::isfinite(value) || (log && value <= 0.0)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

Span range_of(const Chart& chart, bool of_x)
{
    const bool log = of_x ? chart.log_x : chart.log_y;
    Span range;
    for (const Series& s : chart.series)
        for (const double v : of_x ? s.x : s.y) range.add(v, log);
    for (const ReferenceLine& line : of_x ? chart.vertical : chart.horizontal)
        range.add(line.at, log);
    for (const ChartMark& mark : chart.marks) range.add(of_x ? mark.x : mark.y, log);
    if (range.low > range.high)
        return log ? Span{1.0, 10.0} : Span{0.0, 1.0}; // nothing to show
    // a curve that comes near zero is read from zero
    if (!log && range.low > 0.0 && range.low < 0.3 * range.high) range.low = 0.0;
    return range;
}

/// @param headroom share of the axis kept free above the data [-], in [0, 1)
Axis make_axis(Span range, bool log, double headroom)
{
    if (log) {
        const double span = std::max(range.high / range.low, 1.0 + 1e-9);
        return log_axis(range.low, range.high * (std::pow(span, 1.0 / (1.0 - headroom) - 1.0)));
    }
    const double above = (range.high - range.low) * (1.0 / (1.0 - headroom) - 1.0);
    return linear_axis(range.low, range.high + above,
                       headroom > 0.0 ? 8 : 6); // finer: less empty room
}

std::vector<std::string> pick_colours(const std::vector<Series>& series)
{
    std::vector<std::string> colours;
    std::size_t next = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        std::string colour = xml_escape(series[i].colour);
        for (std::size_t k = 0; k < i && colour.empty(); ++k)
            if (!series[i].name.empty() && series[k].name == series[i].name)
                colour = colours[k];
        if (colour.empty()) colour = palette(next++);
        colours.push_back(colour);
    }
    return colours;
}

/// Indices of the lines that are shown, from the left.
std::vector<std::size_t> from_left(const std::vector<ReferenceLine>& lines, const Axis& x)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (std::isfinite(lines[i].at) && (!x.log || lines[i].at > 0.0)) order.push_back(i);
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return lines[a].at < lines[b].at; });
    return order;
}

/// One entry for each name and each number, in rows; the last is in the bottom row.
std::vector<LegendEntry> legend_of(const Chart& chart, const ChartFrame& f)
{
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const Series& s = chart.series[i];
        if (s.name.empty() || std::ranges::count(entries, s.name, &LegendEntry::name) > 0)
            continue;
        entries.push_back({&s, f.colours[i], {}, s.name, 0});
    }
    for (const std::size_t i : from_left(chart.vertical, f.x))
        if (f.vertical[i].number > 0)
            entries.push_back({nullptr, "", {}, chart.vertical[i].label, f.vertical[i].number});
    return entries;
}

void place_legend(std::vector<LegendEntry>& entries, double page_width, Pixel first)
{
    Pixel at = first;
    for (LegendEntry& e : entries) {
        const double width = legend_sample(e) + 8.0 + text_width(e.name, kTickSize) + 18.0;
        // Numbers begin a row of their own.
        const bool begins = e.number == 1 && at.x > first.x;
        if (begins || (at.x > first.x && at.x + width > page_width - kMargin))
            at = {first.x, at.y + 18.0};
        e.at = at;
        at.x += width;
    }
}

/// Texts in a row at the top. @return false: one runs over another line, or leaves the frame
bool place_texts(const std::vector<ReferenceLine>& lines, ChartFrame& f)
{
    double last = f.left; // right end of what stands already [px]
    for (const std::size_t i : from_left(lines, f.x)) {
        const double width = text_width(lines[i].label, kTickSize) + 10.0;
        const double line = f.left + (f.right - f.left) * f.x.share(lines[i].at);
        // to the right of its line, or to the left where it would leave the frame
        const double start = line + width < f.right ? line : line - width;
        if (start < last) return false;
        last = start + width;
        f.vertical[i] = {start + 5.0, 0};
    }
    return true;
}

/// Numbers in one row at the top, each as near to its line as the others let it be.
void place_numbers(const std::vector<ReferenceLine>& lines, ChartFrame& f)
{
    const std::vector<std::size_t> order = from_left(lines, f.x);
    const auto n = static_cast<double>(order.size());
    const double low = f.left + kBadge + 2.0, high = f.right - kBadge - 2.0,
                 step = std::min(2.0 * kBadge + 2.0, (high - low) / std::max(n - 1.0, 1.0));
    struct Run { // of numbers that touch
        double sum = 0.0;
        std::size_t size = 0;
        [[nodiscard]] double mean() const { return sum / static_cast<double>(size); }
    };
    std::vector<Run> runs;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const double line = f.left + (f.right - f.left) * f.x.share(lines[order[k]].at);
        runs.push_back({line - step * static_cast<double>(k), 1});
        while (runs.size() > 1 && runs[runs.size() - 2].mean() >= runs.back().mean()) {
            runs[runs.size() - 2].sum += runs.back().sum;
            runs[runs.size() - 2].size += runs.back().size;
            runs.pop_back();
        }
    }
    std::size_t k = 0;
    for (const Run& run : runs)
        for (std::size_t i = 0; i < run.size; ++i, ++k) {
            const double at = std::clamp(run.mean(), low, high - step * (n - 1.0)) +
                              step * static_cast<double>(k);
            f.vertical[order[k]] = {at, static_cast<int>(k) + 1};
        }
}

double widest_label(const Axis& axis)
{
    double width = 0.0;
    for (const double t : axis.ticks)
        width = std::max(width, text_width(tick_label(axis, t), kTickSize));
    return width;
}

} // namespace

double legend_sample(const LegendEntry& entry)
{
    constexpr double kSample = 26.0; // [px]
    return entry.number > 0 ? 2.0 * kBadge : kSample;
}

ChartFrame lay_out_chart(const Chart& chart)
{
    ChartFrame f;
    f.colours = pick_colours(chart.series);
    const Span range_y = range_of(chart, false);
    f.x = make_axis(range_of(chart, true), chart.log_x, 0.0);
    f.y = make_axis(range_y, chart.log_y, 0.0);
    f.right = chart.width - kMargin - 8.0;
    f.left = kMargin + (chart.y_label.empty() ? 0.0 : 18.0) + widest_label(f.y) + 10.0;
    f.vertical.resize(chart.vertical.size());
    const bool texts = place_texts(chart.vertical, f);
    if (!texts) place_numbers(chart.vertical, f);
    for (const std::size_t i : from_left(chart.vertical, f.x))
        f.lines.push_back(f.left + (f.right - f.left) * f.x.share(chart.vertical[i].at));

    f.top = chart.title.empty() ? kMargin : 48.0;
    f.legend = legend_of(chart, f);
    place_legend(f.legend, chart.width, {kMargin, f.top + 4.0});
    if (!f.legend.empty()) f.top = f.legend.back().at.y + 20.0;
    if (chart.top) f.top += 36.0;
    f.bottom = chart.height - (chart.x_label.empty() ? 34.0 : 54.0);
    if (chart.vertical.empty() && chart.marks.empty()) return f;
    // the label of a mark stands above it
    const int rows = (chart.marks.empty() ? 0 : 1) + (texts && !chart.vertical.empty() ? 1 : 0);
    const double headroom =
        (rows * kLabelRow + 6.0 + (texts ? 0.0 : kNumberRow)) / (f.bottom - f.top);
    f.y = make_axis(range_y, chart.log_y, std::min(headroom, 0.6));
    return f;
}

} // namespace app
