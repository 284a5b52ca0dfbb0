#include "dem/scene/closure_fit.hpp"

#include <cstddef>

namespace dem {

double closed_stiffness(const Closing& c, double pressure)
{
    return c.initial_stiffness + pressure / c.maximum;
}

ClosureFit fit_closure(std::span<const double> stiffness, std::span<const double> pressure)
{
    const auto n = static_cast<double>(stiffness.size());
    double mean_k = 0.0, mean_p = 0.0, pp = 0.0, pk = 0.0;
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        mean_k += stiffness[i] / n;
        mean_p += pressure[i] / n;
    }
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        const double p = pressure[i] - mean_p;
        pp += p * p;
        pk += p * (stiffness[i] - mean_k);
    }
    ClosureFit fit{mean_k - mean_p * pk / pp, pp / pk, {}};
    const Closing law{.initial_stiffness = fit.initial_stiffness, .maximum = fit.maximum};
    for (std::size_t i = 0; i < stiffness.size(); ++i)
        fit.residuals.push_back(closed_stiffness(law, pressure[i]) / stiffness[i] - 1.0);
    return fit;
}

} // namespace dem
