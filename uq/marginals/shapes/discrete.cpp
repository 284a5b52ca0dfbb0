#include "uq/marginals/shapes/discrete.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace uq::discrete {
namespace {

double count(std::span<const double> v) { return static_cast<double>(v.size()); }

double up_to(std::span<const double> v, double x)
{
    return static_cast<double>(std::upper_bound(v.begin(), v.end(), x) - v.begin());
}

double before(std::span<const double> v, double x)
{
    return static_cast<double>(std::lower_bound(v.begin(), v.end(), x) - v.begin());
}

double value(std::span<const double> v, double index)
{
    return v[static_cast<std::size_t>(std::clamp(index, 0.0, count(v) - 1.0))];
}

} // namespace

double cdf(std::span<const double> v, double x) { return up_to(v, x) / count(v); }

double complement(std::span<const double> v, double x)
{
    return (count(v) - up_to(v, x)) / count(v);
}

double quantile(std::span<const double> v, double p)
{
    return value(v, std::ceil(p * count(v)) - 1.0);
}

double upper_quantile(std::span<const double> v, double q)
{
    return value(v, count(v) - std::floor(q * count(v)) - 1.0);
}

double mean(std::span<const double> v)
{
    double about = 0.0;
    for (const double x : v) about += x - v.front();
    return v.front() + about / count(v);
}

double sd(std::span<const double> v)
{
    const double m = mean(v);
    double squares = 0.0;
    for (const double x : v) squares += (x - m) * (x - m);
    return std::sqrt(squares / count(v));
}

double middle(std::span<const double> v, double x)
{
    const double p = 0.5 * (before(v, x) + up_to(v, x)) / count(v);
    return std::clamp(p, 0.25 / count(v), 1.0 - 0.25 / count(v));
}

} // namespace uq::discrete
