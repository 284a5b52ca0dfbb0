#pragma once
/// A line chart as SVG: capacity curves, comparisons with tests, convergence.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace app {

enum class LineStyle { none, solid, dashed, dotted };

/// A value that is not finite, or not positive on a log axis, breaks the line.
struct Series {
    std::string name = {};              ///< in the legend, once; empty: not in the legend
    std::vector<double> x = {}, y = {}; ///< of equal length
    std::string colour = {};            ///< CSS; empty: from the palette, by name
    LineStyle line = LineStyle::solid;
    double width = 1.8;  ///< [px]
    bool points = false; ///< a dot at each value
};

/// Colour i of the palette: the first seven can be told apart with any colour vision. After
/// twelve it begins anew.
[[nodiscard]] const char* palette(std::size_t i);

/// A line and the dotted ends of its band.
struct Band {
    Series line, low, high;

    /// @param width of the ends [px]
    explicit Band(const std::string& colour, double width = 1.0);
    void add(double x, double y, double lower, double upper);
};

struct ReferenceLine {
    double at = 0.0;
    std::string label = {};
};

/// A single point with a label, e.g. the peak.
struct ChartMark {
    double x = 0.0, y = 0.0;
    std::string label = {};
};

/// Second scale along the top: `factor` times the x axis.
struct TopAxis {
    std::string label = {};
    double factor = 1.0; ///< > 0
};

struct Chart {
    std::string title = {}, x_label = {}, y_label = {};
    std::vector<Series> series = {};            ///< drawn in this order
    std::vector<ReferenceLine> vertical = {};   ///< at x
    std::vector<ReferenceLine> horizontal = {}; ///< at y
    std::vector<ChartMark> marks = {};
    std::optional<TopAxis> top = {}; ///< linear x axis only
    bool log_x = false, log_y = false;
    double width = 720.0, height = 460.0; ///< [px], at least 300 x 240
};

void add_band(Chart& chart, const Band& band);

/// Everything finite is inside the frame; a linear axis starts at 0 where the data come near
/// it. Throws std::invalid_argument if a series has unequal lengths or the chart is too small.
[[nodiscard]] std::string line_chart(const Chart& chart);

} // namespace app
