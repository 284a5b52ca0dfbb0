#include "fragility/laws/small_sample.hpp"

#include "core/fit_factors.hpp"

#include <algorithm>
#include <cmath>

namespace fragility {
namespace {

/// Probability within `z` of a standard normal value. Beyond 8 a double holds none that differs
/// from 1 and can be turned back into a quantile.
double within(double z) { return std::erf(std::min(z, 8.0) / std::sqrt(2.0)); }

} // namespace

double small_sample(double confidence, double degrees)
{
    return within(core::fit_student_factor(confidence, std::max(degrees, 1.0)));
}

double small_sample_profile(double confidence, double n)
{
    n = std::max(n, 2.0);
    const double t = core::fit_student_factor(confidence, n - 1.0);
    return within(std::sqrt(n * std::log1p(t * t / (n - 1.0))));
}

} // namespace fragility
