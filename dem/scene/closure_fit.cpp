#include "dem/scene/closure_fit.hpp"

#include <cstddef>

namespace dem {

double closed_stiffness(const Closing& c, double pressure)
{
    return c.initial_stiffness + pressure / c.maximum;
}

ClosureFit fit_closure(std::span<const double> stiffness, std::span<const double> pressure)
{
    // Normal equations of x k_0 + y / V_m = 1 with x = 1 / k and y = p / k.
    double xx = 0.0, xy = 0.0, yy = 0.0, x1 = 0.0, y1 = 0.0;
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        const double x = 1.0 / stiffness[i], y = pressure[i] / stiffness[i];
        xx += x * x;
        xy += x * y;
        yy += y * y;
        x1 += x;
        y1 += y;
    }
    const double determinant = xx * yy - xy * xy;
    ClosureFit fit{(yy * x1 - xy * y1) / determinant, determinant / (xx * y1 - xy * x1), {}};
    for (std::size_t i = 0; i < stiffness.size(); ++i)
        fit.residuals.push_back(
            (fit.initial_stiffness + pressure[i] / fit.maximum) / stiffness[i] - 1.0);
    return fit;
}

} // namespace dem
