#include "app/output/picture/chart_svg.hpp"

#include "app/output/picture/chart_frame.hpp"
#include "app/output/picture/chart_labels.hpp"
#include "app/output/picture/svg_elements.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace app {

namespace {

constexpr const char* kReferenceStyle =
    "stroke=\"#777\" stroke-width=\"1.1\" stroke-dasharray=\"5 3\"";

/// A sensor writes thousands of values in a second: of so many points a line shows only one in
/// each pixel.
constexpr std::size_t kDense = 10'000; // points of a line

bool adds_nothing(const Series& s, const std::vector<Pixel>& run, Pixel at)
{
    return s.x.size() > kDense && !run.empty() &&
           std::hypot(at.x - run.back().x, at.y - run.back().y) < 1.0;
}

std::string draw_series(const Series& s, const std::string& colour, const ChartFrame& f)
{
    std::string drawn;
    std::vector<Pixel> run; // up to the next gap
    const auto flush = [&] {
        if (run.size() == 1 && !s.points) // between two gaps: a line would not show it
            drawn += svg_dot(run.front(), s.width, svg_attribute("fill", colour));
        if (run.size() > 1) drawn += svg_polyline(run, line_attributes(s, colour));
        run.clear();
    };
    for (std::size_t i = 0; i < s.x.size(); ++i) {
        if (!f.shows(s.x[i], s.y[i])) {
            flush();
            continue;
        }
        const Pixel at = f.place(s.x[i], s.y[i]);
        if (s.points) drawn += svg_dot(at, 3.2, svg_attribute("fill", colour));
        if (s.line != LineStyle::none && !adds_nothing(s, run, at)) run.push_back(at);
    }
    flush();
    return drawn;
}

/// A line goes up to the frame, or bends to the number that stands for its label.
std::string draw_vertical_lines(const Chart& chart, const ChartFrame& f)
{
    std::string lines;
    for (std::size_t i = 0; i < chart.vertical.size(); ++i) {
        const ReferenceLine& line = chart.vertical[i];
        if (!f.shows(line.at, f.y.low)) continue;
        const double x = f.place(line.at, f.y.low).x;
        const VerticalLabel& label = f.vertical[i];
        if (label.number == 0) {
            lines += svg_line({x, f.top}, {x, f.bottom}, "");
            continue;
        }
        const Pixel number{label.at, f.top + 2.0 + 2.0 * kBadge}, bend{x, f.top + kNumberRow};
        lines += svg_line(number, bend, "stroke-dasharray=\"none\"") +
                 svg_line(bend, {x, f.bottom}, "");
    }
    return svg_group(kReferenceStyle, lines);
}

std::string draw_horizontal_lines(const Chart& chart, const ChartFrame& f)
{
    std::string lines;
    for (const ReferenceLine& line : chart.horizontal)
        if (f.shows(f.x.low, line.at))
            lines += svg_line(f.place(f.x.low, line.at), f.place(f.x.high, line.at), "");
    return svg_group(kReferenceStyle, lines);
}

std::string draw_marks(const Chart& chart, const ChartFrame& f)
{
    std::string drawn;
    for (const ChartMark& mark : chart.marks) {
        if (!f.shows(mark.x, mark.y)) continue;
        const Pixel at = f.place(mark.x, mark.y);
        drawn += svg_dot(at, 4.2, "fill=\"white\" stroke=\"#222\" stroke-width=\"1.6\"");
    }
    return drawn;
}

} // namespace

const char* palette(std::size_t i)
{
    // Okabe and Ito, and five more
    constexpr std::array kColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                     "#E69F00", "#56B4E9", "#000000", "#7F3C8D",
                                     "#8C564B", "#7F7F7F", "#9ACD32", "#F2666C"};
    return kColours[i % kColours.size()];
}

Band::Band(const std::string& colour, double width)
    : line{.colour = colour}, low{.colour = colour, .line = LineStyle::dotted, .width = width},
      high(low)
{
}

void Band::add(double x, double y, double lower, double upper)
{
    for (Series* const s : {&line, &low, &high}) s->x.push_back(x);
    line.y.push_back(y);
    low.y.push_back(lower);
    high.y.push_back(upper);
}

void add_band(Chart& chart, const Band& band)
{
    chart.series.insert(chart.series.end(), {band.line, band.low, band.high});
}

std::string line_chart(const Chart& chart)
{
    if (!(chart.width >= 300.0 && chart.height >= 240.0))
        throw std::invalid_argument("chart: at least 300 x 240 pixels are needed");
    for (const Series& s : chart.series)
        if (s.x.size() != s.y.size())
            throw std::invalid_argument("chart: series '" + s.name + "' has unequal lengths");

    const ChartFrame frame = lay_out_chart(chart);
    std::string lines;
    for (std::size_t i = 0; i < chart.series.size(); ++i)
        lines += draw_series(chart.series[i], frame.colours[i], frame);
    const std::string body = draw_frame(chart, frame) + draw_horizontal_lines(chart, frame) +
                             lines + draw_vertical_lines(chart, frame) +
                             draw_marks(chart, frame) + draw_labels(chart_labels(chart, frame));
    return svg_page(chart.width, chart.height, chart.title, body);
}

} // namespace app
