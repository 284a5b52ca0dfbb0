#include "fragility/small_sample.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace fragility {
namespace {

double student(double confidence, double degrees)
{
    return boost::math::quantile(boost::math::students_t(degrees), 0.5 + 0.5 * confidence);
}

/// Probability within `z` of a standard normal value. Beyond 8 a double holds none that differs
/// from 1 and can be turned back into a quantile.
double within(double z) { return std::erf(std::min(z, 8.0) / std::sqrt(2.0)); }

} // namespace

double small_sample(double confidence, double degrees)
{
    return within(student(confidence, std::max(degrees, 1.0)));
}

double small_sample_profile(double confidence, double n)
{
    n = std::max(n, 2.0);
    const double t = student(confidence, n - 1.0);
    return within(std::sqrt(n * std::log1p(t * t / (n - 1.0))));
}

} // namespace fragility
