#include "dem/solver/solver_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace dem {

namespace {

constexpr std::size_t kPoints = 5; // over which a peak is read
// The slope at the peak is too small for what happened before it. The factor is a free choice,
// made on scenes 0 to 99 of docs/bench/accuracy/accuracy.md: 95 % of the peaks are within the
// accuracy.
constexpr double kWider = 10.0 / 3.0;
// Local damping takes most of what rings, and so less from the force, than combined damping
// does. With the factor the estimate holds the error of nine of ten of 40 walls of the paper.
constexpr double kWiderLocal = 0.25;

double median(std::vector<double> all)
{
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

} // namespace

double force_error(std::span<const CurvePoint> curve, Damping kind)
{
    std::size_t peak = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        if (std::abs(curve[i].force) > std::abs(curve[peak].force)) peak = i;
    const double force = curve.empty() ? 0.0 : std::abs(curve[peak].force);
    if (!(force > 0.0)) return 0.0;
    const std::size_t last = std::min(curve.size() - 1, std::max(peak, kPoints));
    std::vector<double> damping, all; // per displacement [N]
    double at_peak = 0.0;             // of them, where nothing broke [N]
    for (std::size_t i = last - std::min(last, kPoints) + 1; i <= last; ++i) {
        const double way = std::abs(curve[i].displacement - curve[i - 1].displacement);
        const Energy &now = curve[i].energy, &before = curve[i - 1].energy;
        if (!(way > 0.0)) continue;
        damping.push_back((now.damping - before.damping) / way);
        all.push_back(damping.back() + (now.kinetic - before.kinetic) / way);
        if (i == peak && now.fracture == before.fracture) at_peak = all.back();
    }
    if (all.empty()) return 0.0;
    // Energy that speeds the wall up sets its top and its base apart as well, and counts once.
    const double apart = std::abs(curve[peak].force - curve[peak].base_shear);
    const double taken =
        std::max(std::abs(median(std::move(all))), median(std::move(damping)) + apart);
    const double wider = kind == Damping::local ? kWiderLocal : kWider;
    return std::max(wider * taken, std::min(1.0, wider) * at_peak) / force;
}

} // namespace dem
