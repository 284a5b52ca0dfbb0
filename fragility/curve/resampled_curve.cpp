#include "fragility/curve/resampled_curve.hpp"

#include <algorithm>

namespace fragility {

std::vector<double> resampled(const Curve& curve, double step, std::size_t points)
{
    constexpr double kRounding = 1e-9; // of the last displacement
    const auto& d = curve.displacement;
    std::vector<double> forces;
    std::size_t next = 0; // first point at or beyond x
    for (std::size_t i = 0; i < points && !d.empty(); ++i) {
        const double x = static_cast<double>(i) * step;
        if (x > d.back() * (1.0 + kRounding)) break;
        while (next + 1 < d.size() && d[next] < x) ++next;
        const double x0 = next > 0 ? d[next - 1] : 0.0, x1 = d[next];
        const double f0 = next > 0 ? curve.force[next - 1] : 0.0, f1 = curve.force[next];
        const double t = x1 > x0 ? std::clamp((x - x0) / (x1 - x0), 0.0, 1.0) : 1.0;
        forces.push_back(f0 + t * (f1 - f0));
    }
    return forces;
}

} // namespace fragility
