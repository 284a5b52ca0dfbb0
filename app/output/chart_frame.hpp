#pragma once
/// The frame of a line chart: what range it shows, where it stands on the page, its axes and
/// legend.

#include "app/output/axis_ticks.hpp"
#include "app/output/chart_svg.hpp"
#include "app/output/svg_elements.hpp"

#include <string>
#include <vector>

namespace app {

/// A name in the legend and how its line looks.
struct LegendEntry {
    const Series* series = nullptr;
    std::string colour;
    Pixel at; ///< left end of the sample
};

struct ChartFrame {
    Axis x, y;
    double left = 0.0, right = 0.0, top = 0.0, bottom = 0.0; ///< of the plot [px]
    std::vector<std::string> colours;                        ///< of each series
    std::vector<LegendEntry> legend;
    std::vector<int> rows; ///< of the label of each vertical reference line, from the top;
                           ///< labels of a row do not overlap

    [[nodiscard]] Pixel place(double x, double y) const;
    /// Whether a value can be drawn: finite, and positive on a log axis.
    [[nodiscard]] bool shows(double x, double y) const;
};

inline constexpr double kLabelRow = 17.0; // height of a row of labels [px]

[[nodiscard]] ChartFrame lay_out_chart(const Chart& chart);

/// Grid, ticks, axis labels, title and legend.
[[nodiscard]] std::string draw_frame(const Chart& chart, const ChartFrame& frame);

/// Attributes of the line of a series.
[[nodiscard]] std::string line_attributes(const Series& series, const std::string& colour);

} // namespace app
