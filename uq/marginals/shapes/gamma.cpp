#include "uq/marginals/shapes/gamma.hpp"

#include "uq/marginals/shapes/boost_tails.hpp"
#include "uq/marginals/shapes/shape_checks.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <limits>

namespace uq {
namespace {

using boost_tails::kQuiet;
using boost_tails::solved;
namespace bm = boost::math;

} // namespace

void check(const Gamma& s)
{
    require_positive("gamma: shape", s.shape);
    require_positive("gamma: scale", s.scale);
}

Gamma gamma_from_moments(double mean, double cov)
{
    require_positive_moments("gamma", mean, cov);
    return {1.0 / (cov * cov), mean * cov * cov};
}

Range support(const Gamma&) { return {0.0, std::numeric_limits<double>::infinity()}; }
double density(const Gamma& s, double x)
{
    if (x < 0.0) return 0.0;
    return bm::gamma_p_derivative(s.shape, x / s.scale, kQuiet) / s.scale;
}
double lower_tail(const Gamma& s, double x)
{
    return x > 0.0 ? bm::gamma_p(s.shape, x / s.scale, kQuiet) : 0.0;
}
double upper_tail(const Gamma& s, double x)
{
    return x > 0.0 ? bm::gamma_q(s.shape, x / s.scale, kQuiet) : 1.0;
}
double at_lower(const Gamma& s, double p)
{
    return s.scale * solved(
                         bm::gamma_p_inv(s.shape, p, kQuiet), p,
                         [&](double t) { return bm::gamma_p(s.shape, t, kQuiet); },
                         [&](double t) { return bm::gamma_p_derivative(s.shape, t, kQuiet); });
}
double at_upper(const Gamma& s, double q)
{
    return s.scale * solved(
                         bm::gamma_q_inv(s.shape, q, kQuiet), q,
                         [&](double t) { return bm::gamma_q(s.shape, t, kQuiet); },
                         [&](double t) { return -bm::gamma_p_derivative(s.shape, t, kQuiet); });
}
MeanSd mean_sd(const Gamma& s) { return {s.shape * s.scale, std::sqrt(s.shape) * s.scale}; }

std::span<const ShapeForm<Gamma>> forms(const Gamma*)
{
    static constexpr ShapeForm<Gamma> all[] = {
        {{{{"mean"}, {"cov", true}}},
         [](const double* p) { return gamma_from_moments(p[0], p[1]); }},
        {{{{"mean"}, {"sd"}}},
         [](const double* p) { return gamma_from_moments(p[0], p[1] / std::abs(p[0])); }},
    };
    return all;
}

} // namespace uq
