#include "app/output/chart_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr double kMargin = 18.0, kTickSize = 12.0, kSample = 26.0; // [px]

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value, bool log)
    {
        if (!std::isfinite(value) || (log && value <= 0.0)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

Range range_of(const Chart& chart, bool of_x)
{
    const bool log = of_x ? chart.log_x : chart.log_y;
    Range range;
    for (const Series& s : chart.series)
        for (const double v : of_x ? s.x : s.y) range.add(v, log);
    for (const ReferenceLine& line : of_x ? chart.vertical : chart.horizontal)
        range.add(line.at, log);
    for (const ChartMark& mark : chart.marks) range.add(of_x ? mark.x : mark.y, log);
    if (range.low > range.high)
        return log ? Range{1.0, 10.0} : Range{0.0, 1.0}; // nothing to show
    // a curve that comes near zero is read from zero
    if (!log && range.low > 0.0 && range.low < 0.3 * range.high) range.low = 0.0;
    return range;
}

/// @param headroom share of the axis kept free above the data [-], in [0, 1)
Axis make_axis(Range range, bool log, double headroom)
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

/// One entry for each name, in rows; returns the entries with the last at the bottom row.
std::vector<LegendEntry> place_legend(const Chart& chart,
                                      const std::vector<std::string>& colours, Pixel first)
{
    std::vector<LegendEntry> entries;
    Pixel at = first;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const Series& s = chart.series[i];
        const bool known = std::ranges::any_of(
            entries, [&](const LegendEntry& e) { return e.series->name == s.name; });
        if (s.name.empty() || known) continue;
        const double width = kSample + 8.0 + text_width(s.name, kTickSize) + 18.0;
        if (at.x > first.x && at.x + width > chart.width - kMargin) at = {first.x, at.y + 18.0};
        entries.push_back({&s, colours[i], at});
        at.x += width;
    }
    return entries;
}

std::vector<int> label_rows(const std::vector<ReferenceLine>& lines, const Axis& x, double left,
                            double right)
{
    std::vector<std::size_t> order(lines.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return lines[a].at < lines[b].at; });
    std::vector<int> rows(lines.size(), 0);
    std::vector<double> row_ends; // right end of the last label in each row [px]
    for (const std::size_t i : order) {
        const double width = text_width(lines[i].label, kTickSize) + 10.0;
        const double line = left + (right - left) * x.share(lines[i].at);
        // to the right of its line, or to the left where it would leave the frame
        const double start = line + width < right ? line : line - width;
        std::size_t row = 0;
        while (row < row_ends.size() && row_ends[row] > start) ++row;
        if (row == row_ends.size()) row_ends.push_back(0.0);
        row_ends[row] = start + width;
        rows[i] = static_cast<int>(row);
    }
    return rows;
}

double widest_label(const Axis& axis)
{
    double width = 0.0;
    for (const double t : axis.ticks)
        width = std::max(width, text_width(tick_label(axis, t), kTickSize));
    return width;
}

std::string grid_line(Pixel a, Pixel b, bool strong)
{
    return svg_line(a, b, svg_stroke(strong ? "#e2e2e2" : "#f0f0f0", 1.0));
}

std::string draw_x_axis(const Chart& chart, const ChartFrame& f)
{
    std::string drawn;
    for (const double t : f.x.minor)
        drawn += grid_line(f.place(t, f.y.low), f.place(t, f.y.high), false);
    for (const double t : f.x.ticks) {
        const double x = f.place(t, f.y.low).x;
        drawn += grid_line({x, f.top}, {x, f.bottom}, true) +
                 svg_line({x, f.bottom}, {x, f.bottom + 5.0}, svg_stroke("#555", 1.0)) +
                 svg_text({x, f.bottom + 19.0}, tick_label(f.x, t),
                          "text-anchor=\"middle\" font-size=\"12\"");
    }
    return drawn + svg_text({(f.left + f.right) / 2, f.bottom + 40.0}, chart.x_label,
                            "text-anchor=\"middle\"");
}

std::string draw_y_axis(const Chart& chart, const ChartFrame& f)
{
    std::string drawn;
    for (const double t : f.y.minor)
        drawn += grid_line(f.place(f.x.low, t), f.place(f.x.high, t), false);
    for (const double t : f.y.ticks) {
        const double y = f.place(f.x.low, t).y;
        drawn += grid_line({f.left, y}, {f.right, y}, true) +
                 svg_line({f.left - 5.0, y}, {f.left, y}, svg_stroke("#555", 1.0)) +
                 svg_text({f.left - 9.0, y + 4.2}, tick_label(f.y, t),
                          "text-anchor=\"end\" font-size=\"12\"");
    }
    const std::string x = svg_number(kMargin + 4.0), y = svg_number((f.top + f.bottom) / 2);
    return drawn +
           svg_text({kMargin + 4.0, (f.top + f.bottom) / 2}, chart.y_label,
                    "text-anchor=\"middle\" transform=\"rotate(-90 " + x + ' ' + y + ")\"");
}

std::string draw_top_axis(const Chart& chart, const ChartFrame& f)
{
    if (!chart.top || f.x.log || !(chart.top->factor > 0.0)) return {};
    const double factor = chart.top->factor;
    const Axis axis = linear_axis(f.x.low * factor, f.x.high * factor, 8);
    std::string drawn;
    for (const double t : axis.ticks) {
        if (t / factor < f.x.low || t / factor > f.x.high * (1.0 + 1e-12)) continue;
        const double x = f.place(t / factor, f.y.low).x;
        drawn += svg_line({x, f.top - 5.0}, {x, f.top}, svg_stroke("#555", 1.0)) +
                 svg_text({x, f.top - 9.0}, tick_label(axis, t),
                          "text-anchor=\"middle\" font-size=\"12\" fill=\"#555\"");
    }
    return drawn + svg_text({(f.left + f.right) / 2, f.top - 27.0}, chart.top->label,
                            "text-anchor=\"middle\" font-size=\"12\" fill=\"#555\"");
}

std::string draw_legend(const ChartFrame& f)
{
    std::string drawn;
    for (const LegendEntry& entry : f.legend) {
        const Pixel a = entry.at, b{a.x + kSample, a.y}, middle{a.x + kSample / 2, a.y};
        if (entry.series->line != LineStyle::none)
            drawn += svg_line(a, b, line_attributes(*entry.series, entry.colour));
        if (entry.series->points)
            drawn += svg_dot(middle, 3.2, svg_attribute("fill", entry.colour));
        drawn += svg_text({b.x + 8.0, b.y + 4.2}, entry.series->name, "font-size=\"12\"");
    }
    return drawn;
}

} // namespace

Pixel ChartFrame::place(double value_x, double value_y) const
{
    return {left + (right - left) * x.share(value_x),
            bottom - (bottom - top) * y.share(value_y)};
}

bool ChartFrame::shows(double value_x, double value_y) const
{
    return std::isfinite(value_x) && std::isfinite(value_y) && (!x.log || value_x > 0.0) &&
           (!y.log || value_y > 0.0);
}

std::string line_attributes(const Series& series, const std::string& colour)
{
    std::string text = svg_stroke(colour, series.width) + "stroke-linejoin=\"round\" ";
    if (series.line == LineStyle::dashed) text += "stroke-dasharray=\"7 4\"";
    if (series.line == LineStyle::dotted) text += "stroke-dasharray=\"1.5 3.5\"";
    return text;
}

ChartFrame lay_out_chart(const Chart& chart)
{
    ChartFrame f;
    f.colours = pick_colours(chart.series);
    f.top = chart.title.empty() ? kMargin : 48.0;
    f.legend = place_legend(chart, f.colours, {kMargin, f.top + 4.0});
    if (!f.legend.empty()) f.top = f.legend.back().at.y + 20.0;
    if (chart.top) f.top += 36.0;
    f.bottom = chart.height - (chart.x_label.empty() ? 34.0 : 54.0);

    const Range range_y = range_of(chart, false);
    f.x = make_axis(range_of(chart, true), chart.log_x, 0.0);
    f.y = make_axis(range_y, chart.log_y, 0.0);
    f.right = chart.width - kMargin - 8.0;
    f.left = kMargin + (chart.y_label.empty() ? 0.0 : 18.0) + widest_label(f.y) + 10.0;
    f.rows = label_rows(chart.vertical, f.x, f.left, f.right);
    if (chart.vertical.empty() && chart.marks.empty()) return f;
    int rows = chart.marks.empty() ? 0 : 1; // the label of a mark stands above it
    for (const int row : f.rows) rows = std::max(rows, row + (chart.marks.empty() ? 1 : 2));
    const double headroom = (rows * kLabelRow + 6.0) / (f.bottom - f.top);
    f.y = make_axis(range_y, chart.log_y, std::min(headroom, 0.6));
    return f;
}

std::string draw_frame(const Chart& chart, const ChartFrame& f)
{
    return svg_text({kMargin, 30.0}, chart.title, "font-size=\"16\" font-weight=\"bold\"") +
           draw_x_axis(chart, f) + draw_y_axis(chart, f) +
           svg_rectangle({f.left, f.top}, f.right - f.left, f.bottom - f.top,
                         svg_stroke("#555", 1.0)) +
           draw_top_axis(chart, f) + draw_legend(f);
}

} // namespace app
