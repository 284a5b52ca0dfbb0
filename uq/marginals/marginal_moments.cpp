/// Parameters from mean and coefficient of variation.

#include "uq/marginals/marginal.hpp"
#include "uq/marginals/marginal_refusal.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <numbers>
#include <string>

namespace uq {
namespace {

void check_moments(const char* shape, double mean, double cov)
{
    const std::string name(shape);
    if (!std::isfinite(mean)) refuse((name + ": mean").c_str(), mean, "a finite number");
    if (mean == 0.0)
        refuse((name + ": mean").c_str(), mean,
               "not 0, a coefficient of variation scales by it");
    if (!(cov > 0.0 && std::isfinite(cov)))
        refuse((name + ": coefficient of variation").c_str(), cov, "> 0");
}

void check_positive_mean(const char* shape, double mean, double cov)
{
    check_moments(shape, mean, cov);
    if (!(mean > 0.0)) refuse((std::string(shape) + ": mean").c_str(), mean, "> 0");
}

/// ln(1 + cov^2) of a Weibull of shape 1 / e.
double weibull_spread(double e)
{
    return std::log1p(boost::math::tgamma1pm1(2.0 * e)) -
           2.0 * std::log1p(boost::math::tgamma1pm1(e));
}

} // namespace

Normal normal_from_moments(double mean, double cov)
{
    check_moments("normal", mean, cov);
    return {mean, cov * std::abs(mean)};
}

Lognormal lognormal_from_moments(double mean, double cov)
{
    check_positive_mean("lognormal", mean, cov);
    const double variance = std::log1p(cov * cov);
    return {std::log(mean) - 0.5 * variance, std::sqrt(variance)};
}

Uniform uniform_from_moments(double mean, double cov)
{
    check_moments("uniform", mean, cov);
    const double half = std::numbers::sqrt3 * cov * std::abs(mean);
    return {mean - half, mean + half};
}

Gamma gamma_from_moments(double mean, double cov)
{
    check_positive_mean("gamma", mean, cov);
    return {1.0 / (cov * cov), mean * cov * cov};
}

Weibull weibull_from_moments(double mean, double cov)
{
    check_positive_mean("weibull", mean, cov);
    constexpr double kSmallest = 1e-3, kLargest = 100.0;
    if (!(cov >= kSmallest && cov <= kLargest))
        refuse("weibull: coefficient of variation", cov, "in [0.001, 100]");
    const double target = std::log1p(cov * cov);
    std::uintmax_t steps = 200;
    const auto bracket = boost::math::tools::toms748_solve(
        [target](double e) { return weibull_spread(e) - target; }, 0.1 * kSmallest, 20.0,
        boost::math::tools::eps_tolerance<double>(52), steps);
    const double e = 0.5 * (bracket.first + bracket.second);
    return {1.0 / e, mean / (1.0 + boost::math::tgamma1pm1(e))};
}

Gumbel gumbel_from_moments(double mean, double cov)
{
    check_moments("gumbel", mean, cov);
    const double scale = cov * std::abs(mean) * (std::sqrt(6.0) / std::numbers::pi);
    return {mean - std::numbers::egamma * scale, scale};
}

Beta beta_from_moments(double mean, double cov, double lower, double upper)
{
    check_moments("beta", mean, cov);
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

} // namespace uq
