/// Beta and gamma: their tails and inverses by Boost.Math (in long double), the inverses polished.

#include "uq/marginals/marginal_shape.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace uq::shape {
namespace {

namespace bm = boost::math;
using bm::policies::ignore_error;

/// Nothing throws: ends of the support are met as 0 and infinity.
constexpr bm::policies::policy<
    bm::policies::domain_error<ignore_error>, bm::policies::pole_error<ignore_error>,
    bm::policies::overflow_error<ignore_error>, bm::policies::evaluation_error<ignore_error>>
    kQuiet{};

/// Newton for ln tail(x) = ln p over ln x: exact where the tail is a power of x.
/// @param tail P, @param slope dP/dx; of x
template <class Tail, class Slope> double solved(double x, double p, Tail tail, Slope slope)
{
    constexpr int kSteps = 100; // 3 do from a start good to half the digits
    for (int i = 0; i < kSteps; ++i) {
        const double value = tail(x);
        const double step = std::log(value / p) * (value / (x * slope(x)));
        if (!std::isfinite(step)) break; // x is 0 or beyond what double holds
        x *= std::exp(-step);
        if (std::abs(step) < 4.0 * std::numeric_limits<double>::epsilon()) break;
    }
    return x;
}

/// Of the beta distribution over (0, 1): the quantile and its distance to one, both accurate.
struct Split {
    double t, y;
};

double log_beta(double alpha, double beta)
{
    return bm::lgamma(alpha) + bm::lgamma(beta) - bm::lgamma(alpha + beta);
}

/// Below kFar, Boost 1.74 finds no root or throws: from t^alpha / (alpha B(alpha, beta)) instead,
/// the leading term of P, from where Newton does not turn back.
constexpr double kFar = 1e-6;

Split beta_quantile(double alpha, double beta, double p)
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

// Beta.

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
    return between_ends(s, beta_quantile(s.alpha, s.beta, p));
}
double at_upper(const Beta& s, double q)
{
    const Split mirrored = beta_quantile(s.beta, s.alpha, q);
    return between_ends(s, {mirrored.y, mirrored.t});
}

// Gamma.

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

} // namespace uq::shape
