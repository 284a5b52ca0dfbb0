#include "uq/marginals/shapes/beta.hpp"

#include "uq/marginals/shapes/boost_tails.hpp"
#include "uq/marginals/shapes/shape_checks.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>

namespace uq {
namespace {

using boost_tails::kQuiet;
using boost_tails::solved;
namespace bm = boost::math;

/// A quantile of the beta distribution over (0, 1) and its distance to one, both accurate.
struct Split {
    double t, y;
};

double log_beta(double alpha, double beta)
{
    return bm::lgamma(alpha) + bm::lgamma(beta) - bm::lgamma(alpha + beta);
}

/// Below kFar, Boost 1.74 finds no root or throws: from t^alpha / (alpha B(alpha, beta))
/// instead, the leading term of P, from where Newton does not turn back.
constexpr double kFar = 1e-6;

Split split_quantile(double alpha, double beta, double p)
{
    double y = 0.0;
    double t = 0.0;
    if (p < kFar) {
        t = std::min(0.5, std::exp((std::log(p * alpha) + log_beta(alpha, beta)) / alpha));
        y = 1.0 - t;
    } else {
        t = bm::ibeta_inv(alpha, beta, p, &y, kQuiet);
    }
    if (t <= y) {
        t = solved(
            t, p, [&](double v) { return bm::ibeta(alpha, beta, v, kQuiet); },
            [&](double v) { return bm::ibeta_derivative(alpha, beta, v, kQuiet); });
        return {t, 1.0 - t};
    }
    y = solved(
        y, p, [&](double v) { return bm::ibetac(beta, alpha, v, kQuiet); },
        [&](double v) { return -bm::ibeta_derivative(beta, alpha, v, kQuiet); });
    return {1.0 - y, y};
}

double between_ends(const Beta& s, const Split& at)
{
    const double width = s.upper - s.lower;
    return at.t < at.y ? s.lower + width * at.t : s.upper - width * at.y;
}

} // namespace

void check(const Beta& s)
{
    require_positive("beta: alpha", s.alpha);
    require_positive("beta: beta", s.beta);
    require_ends("beta: upper end", s.lower, s.upper);
}

Beta beta_from_moments(double mean, double cov, double lower, double upper)
{
    require_moments("beta", mean, cov);
    if (!(std::isfinite(lower) && std::isfinite(upper) && lower < mean && mean < upper))
        refuse("beta: mean", mean, "between the ends, and these finite");
    const double width = upper - lower;
    const double m = (mean - lower) / width, rest = (upper - mean) / width;
    const double s = cov * std::abs(mean) / width;
    const double sum = m * rest / (s * s) - 1.0;
    if (!(sum > 0.0))
        refuse("beta: coefficient of variation", cov,
               "below sqrt((mean - lower) (upper - mean)) / |mean|");
    return {m * sum, rest * sum, lower, upper};
}

Range support(const Beta& s) { return {s.lower, s.upper}; }
double density(const Beta& s, double x)
{
    const double width = s.upper - s.lower;
    const double t = (x - s.lower) / width;
    const double y = (s.upper - x) / width;
    return (t < y ? bm::ibeta_derivative(s.alpha, s.beta, t, kQuiet)
                  : bm::ibeta_derivative(s.beta, s.alpha, y, kQuiet)) /
           width;
}
double lower_tail(const Beta& s, double x)
{
    if (x <= s.lower) return 0.0;
    if (x >= s.upper) return 1.0;
    const double width = s.upper - s.lower;
    const double t = (x - s.lower) / width;
    const double y = (s.upper - x) / width;
    return t < y ? bm::ibeta(s.alpha, s.beta, t, kQuiet)
                 : bm::ibetac(s.beta, s.alpha, y, kQuiet);
}
double upper_tail(const Beta& s, double x)
{
    return lower_tail(Beta{s.beta, s.alpha, -s.upper, -s.lower}, -x);
}
double at_lower(const Beta& s, double p)
{
    return between_ends(s, split_quantile(s.alpha, s.beta, p));
}
double at_upper(const Beta& s, double q)
{
    const Split mirrored = split_quantile(s.beta, s.alpha, q);
    return between_ends(s, {mirrored.y, mirrored.t});
}
MeanSd mean_sd(const Beta& s)
{
    const double sum = s.alpha + s.beta, width = s.upper - s.lower;
    return {s.lower + width * (s.alpha / sum),
            width / sum * std::sqrt(s.alpha * s.beta / (sum + 1.0))};
}

std::span<const ShapeForm<Beta>> forms(const Beta*)
{
    static constexpr ShapeForm<Beta> all[] = {
        {{{{"mean"}, {"cov", true}, {"lower"}, {"upper"}}},
         [](const double* p) { return beta_from_moments(p[0], p[1], p[2], p[3]); }},
        {{{{"mean"}, {"sd"}, {"lower"}, {"upper"}}},
         [](const double* p) {
             return beta_from_moments(p[0], p[1] / std::abs(p[0]), p[2], p[3]);
         }},
    };
    return all;
}

} // namespace uq
