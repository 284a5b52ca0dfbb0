#include "app/output/picture/chart_frame.hpp"

#include <cmath>

namespace app {

namespace {

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
    const std::string x = svg_number(kChartMargin + 4.0),
                      y = svg_number((f.top + f.bottom) / 2);
    return drawn +
           svg_text({kChartMargin + 4.0, (f.top + f.bottom) / 2}, chart.y_label,
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
        const double width = legend_sample(entry);
        const Pixel a = entry.at, b{a.x + width, a.y}, middle{a.x + width / 2, a.y};
        if (entry.number > 0) drawn += draw_number(middle, std::to_string(entry.number));
        if (entry.series != nullptr && entry.series->line != LineStyle::none)
            drawn += svg_line(a, b, line_attributes(*entry.series, entry.colour));
        if (entry.series != nullptr && entry.series->points)
            drawn += svg_dot(middle, 3.2, svg_attribute("fill", entry.colour));
        drawn += svg_text({b.x + 8.0, b.y + 4.2}, entry.name, "font-size=\"12\"");
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

std::string draw_number(Pixel middle, const std::string& text)
{
    return svg_dot(middle, kBadge - 0.5, "fill=\"white\" stroke=\"#555\" stroke-width=\"1\"") +
           svg_text({middle.x, middle.y + 3.8}, text,
                    "text-anchor=\"middle\" font-size=\"10.5\"");
}

std::string draw_frame(const Chart& chart, const ChartFrame& f)
{
    return svg_text({kChartMargin, 30.0}, chart.title,
                    "font-size=\"16\" font-weight=\"bold\"") +
           draw_x_axis(chart, f) + draw_y_axis(chart, f) +
           svg_rectangle({f.left, f.top}, f.right - f.left, f.bottom - f.top,
                         svg_stroke("#555", 1.0)) +
           draw_top_axis(chart, f) + draw_legend(f);
}

} // namespace app
