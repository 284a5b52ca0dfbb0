#pragma once
/// Axes of a chart: range, round tick values and their text.

#include <string>
#include <vector>

namespace app {

struct Axis {
    double low = 0.0, high = 1.0; ///< low < high; both > 0 if log
    bool log = false;
    std::vector<double> ticks; ///< labelled, ascending, within [low, high]
    std::vector<double> minor; ///< unlabelled, log only

    /// 0 at low, 1 at high.
    [[nodiscard]] double share(double value) const;
};

/// Ticks of 1, 2 or 5 times a power of ten, about `wanted` of them; the range grows outwards to
/// ticks. What lies within 2 % of a tick step beyond a tick does not grow it. Bounds in any
/// order; equal (to nine digits) bounds get a range around them.
[[nodiscard]] Axis linear_axis(double low, double high, int wanted = 6);

/// Labels at decades if there are four or more, else at 1, 2, 5 times decades, else as on a
/// linear axis; the range grows by 4 %.
/// @param low, high > 0
[[nodiscard]] Axis log_axis(double low, double high);

/// "20 000" (thin space), "0.25", "2·10⁻⁶"; all labels of a linear axis with the same decimals.
[[nodiscard]] std::string tick_label(const Axis& axis, double tick);

} // namespace app
