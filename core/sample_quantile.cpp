#include "core/sample_quantile.hpp"

#include <algorithm>
#include <cstddef>

namespace core {

double sample_quantile(std::span<const double> sorted, double p)
{
    const double at = p * static_cast<double>(sorted.size() - 1);
    const auto k = static_cast<std::size_t>(at);
    if (k + 1 >= sorted.size()) return sorted.back();
    return sorted[k] + (at - static_cast<double>(k)) * (sorted[k + 1] - sorted[k]);
}

double unbiased_quantile(std::span<const double> sorted, double p)
{
    const auto n = static_cast<double>(sorted.size());
    const double place = std::clamp((n + 1.0 / 3.0) * p + 1.0 / 3.0, 1.0, n);
    const auto below = static_cast<std::size_t>(place);
    if (below >= sorted.size()) return sorted.back();
    return sorted[below - 1] +
           (place - static_cast<double>(below)) * (sorted[below] - sorted[below - 1]);
}

} // namespace core
