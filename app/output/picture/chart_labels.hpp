#pragma once
/// Texts within the frame of a line chart: where each stands, so that none covers another, a
/// line of data or the frame.

#include "app/output/picture/chart_frame.hpp"
#include "app/output/picture/svg_elements.hpp"

#include <optional>
#include <string>
#include <vector>

namespace app {

struct ChartLabel {
    Pixel low, high; ///< left upper and right lower corner of its box
    std::string text;
    bool numbered = false;      ///< in a circle; the legend says what it stands for
    std::optional<Pixel> point; ///< far away: a line leads to it
};

/// Labels of reference lines, then of marks; those of what is not shown are left out.
[[nodiscard]] std::vector<ChartLabel> chart_labels(const Chart& chart, const ChartFrame& frame);

[[nodiscard]] std::string draw_labels(const std::vector<ChartLabel>& labels);

} // namespace app
