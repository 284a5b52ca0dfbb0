#include "uq/marginals/normal_rule.hpp"

#include "core/gauss_legendre.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace uq {
namespace {

constexpr double kEnd = 37.0; // P(Z > 37) = 5.7e-300

void add(NormalRule& rule, double z, double weight)
{
    rule.z.push_back(z);
    rule.weight.push_back(weight * std::exp(-0.5 * z * z) *
                          (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2));
}

} // namespace

NormalRule normal_rule(std::vector<double> breaks)
{
    std::erase_if(breaks, [](double z) { return !(std::abs(z) < kEnd); });
    for (double z = -kEnd; z <= kEnd; z += 1.0) breaks.push_back(z);
    std::ranges::sort(breaks);
    NormalRule rule;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double middle = 0.5 * (breaks[i - 1] + breaks[i]);
        const double half = 0.5 * (breaks[i] - breaks[i - 1]);
        for (std::size_t k = 0; k < core::kGauss30.node.size(); ++k) { // the positive half
            add(rule, middle - half * core::kGauss30.node[k], half * core::kGauss30.weight[k]);
            add(rule, middle + half * core::kGauss30.node[k], half * core::kGauss30.weight[k]);
        }
    }
    return rule;
}

} // namespace uq
