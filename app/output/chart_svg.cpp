#include "app/output/chart_svg.hpp"

#include "app/output/chart_frame.hpp"
#include "app/output/svg_elements.hpp"

#include <array>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace app {

namespace {

constexpr const char* kReferenceStyle =
    "stroke=\"#777\" stroke-width=\"1.1\" stroke-dasharray=\"5 3\"";

/// Text with a white rim, readable over lines.
std::string label(Pixel at, std::string_view text, const std::string& anchor)
{
    const std::string style = "font-size=\"12\" text-anchor=\"" + anchor + "\" ";
    return svg_text(at, text,
                    style + "stroke=\"white\" stroke-width=\"4\" stroke-linejoin=\"round\" "
                            "fill=\"white\"") +
           svg_text(at, text, style);
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
        if (s.line != LineStyle::none) run.push_back(at);
    }
    flush();
    return drawn;
}

std::string draw_vertical_lines(const Chart& chart, const ChartFrame& f)
{
    std::string lines, labels;
    for (std::size_t i = 0; i < chart.vertical.size(); ++i) {
        const ReferenceLine& line = chart.vertical[i];
        if (!f.shows(line.at, f.y.low)) continue;
        const double x = f.place(line.at, f.y.low).x;
        lines += svg_line({x, f.top}, {x, f.bottom}, "");
        const bool fits = x + text_width(line.label, 12.0) + 10.0 < f.right;
        labels += label({fits ? x + 5.0 : x - 5.0, f.top + 13.0 + kLabelRow * f.rows[i]},
                        line.label, fits ? "start" : "end");
    }
    return svg_group(kReferenceStyle, lines) + labels;
}

/// How much of the lines runs through a box: samples along every piece that lie in it.
int crowd(const Chart& chart, const ChartFrame& f, Pixel low, Pixel high)
{
    constexpr int kSamples = 16; // per piece
    int inside = 0;
    for (const Series& s : chart.series)
        for (std::size_t i = 0; i + 1 < s.x.size(); ++i) {
            if (!f.shows(s.x[i], s.y[i]) || !f.shows(s.x[i + 1], s.y[i + 1])) continue;
            const Pixel p = f.place(s.x[i], s.y[i]), q = f.place(s.x[i + 1], s.y[i + 1]);
            for (int k = 0; k <= kSamples; ++k) {
                const double t = static_cast<double>(k) / kSamples;
                const double x = p.x + t * (q.x - p.x), y = p.y + t * (q.y - p.y);
                inside += x > low.x && x < high.x && y > low.y && y < high.y;
            }
        }
    return inside;
}

/// At the end and the side of a horizontal line where the fewest lines run through the text.
std::string label_horizontal(const Chart& chart, const ChartFrame& f, double y,
                             const std::string& text)
{
    const double width = text_width(text, 12.0) + 8.0;
    std::string best;
    int least = std::numeric_limits<int>::max();
    for (const bool right : {true, false})
        for (const bool above : {true, false}) {
            const double base = above ? y - 5.0 : y + 14.0;
            if (base - 12.0 < f.top || base + 4.0 > f.bottom) continue;
            const Pixel low{right ? f.right - width : f.left, base - 14.0};
            const int busy = crowd(chart, f, low, {low.x + width, base + 5.0});
            if (busy >= least) continue;
            least = busy;
            best = label({right ? f.right - 5.0 : f.left + 5.0, base}, text,
                         right ? "end" : "start");
        }
    return best;
}

std::string draw_horizontal_lines(const Chart& chart, const ChartFrame& f)
{
    std::string lines;
    for (const ReferenceLine& line : chart.horizontal)
        if (f.shows(f.x.low, line.at))
            lines += svg_line(f.place(f.x.low, line.at), f.place(f.x.high, line.at), "");
    return svg_group(kReferenceStyle, lines);
}

std::string draw_horizontal_labels(const Chart& chart, const ChartFrame& f)
{
    std::string labels;
    for (const ReferenceLine& line : chart.horizontal)
        if (f.shows(f.x.low, line.at))
            labels += label_horizontal(chart, f, f.place(f.x.low, line.at).y, line.label);
    return labels;
}

std::string draw_marks(const Chart& chart, const ChartFrame& f)
{
    std::string drawn;
    for (const ChartMark& mark : chart.marks) {
        if (!f.shows(mark.x, mark.y)) continue;
        const Pixel at = f.place(mark.x, mark.y);
        const bool fits = at.x + text_width(mark.label, 12.0) + 10.0 < f.right;
        drawn += svg_dot(at, 4.2, "fill=\"white\" stroke=\"#222\" stroke-width=\"1.6\"") +
                 label({fits ? at.x + 8.0 : at.x - 8.0, at.y - 8.0}, mark.label,
                       fits ? "start" : "end");
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
                             draw_horizontal_labels(chart, frame) + draw_marks(chart, frame);
    return svg_page(chart.width, chart.height, chart.title, body);
}

} // namespace app
