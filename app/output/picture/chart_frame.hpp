#pragma once
/// The frame of a line chart: what range it shows, where it stands on the page, its axes and
/// legend.

#include "app/output/picture/axis_ticks.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/output/picture/svg_elements.hpp"

#include <string>
#include <vector>

namespace app {

/// A name in the legend and how its line looks.
struct LegendEntry {
    const Series* series = nullptr; ///< nullptr: the number of a reference line
    std::string colour;
    Pixel at; ///< left end of the sample
    std::string name;
    int number = 0;
};

/// The label of a vertical reference line, or its number.
struct VerticalLabel {
    double at = 0.0; ///< left end of the text, middle of the number [px]
    int number = 0;  ///< from 1 at the left; 0: the text stands at the line
};

struct ChartFrame {
    Axis x, y;
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0; ///< of the plot [px]
    std::vector<std::string> colours;                        ///< of each series
    std::vector<LegendEntry> legend;
    std::vector<VerticalLabel> vertical; ///< of each vertical reference line
    std::vector<double> lines;           ///< where these lines are, of those shown [px]

    [[nodiscard]] Pixel place(double x, double y) const;
    /// Whether a value can be drawn: finite, and positive on a log axis.
    [[nodiscard]] bool shows(double x, double y) const;
};

inline constexpr double kChartMargin = 18.0; ///< around a chart [px]
inline constexpr double kLabelRow = 17.0;    ///< height of a row of labels [px]
inline constexpr double kBadge = 8.0;        ///< radius of a number [px]
inline constexpr double kNumberRow =
    29.0; ///< height of numbers and the way to their lines [px]

[[nodiscard]] ChartFrame lay_out_chart(const Chart& chart);

/// Grid, ticks, axis labels, title and legend.
[[nodiscard]] std::string draw_frame(const Chart& chart, const ChartFrame& frame);

/// Width of what an entry of the legend shows before its name [px].
[[nodiscard]] double legend_sample(const LegendEntry& entry);

/// A number in a circle.
[[nodiscard]] std::string draw_number(Pixel middle, const std::string& text);

/// Attributes of the line of a series.
[[nodiscard]] std::string line_attributes(const Series& series, const std::string& colour);

} // namespace app
