#include "fragility/law.hpp"

#include "fragility/standard_law.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

constexpr std::array<std::string_view, 4> kNames{"lognormal", "normal", "weibull", "gamma"};

/// cv^2 of a Weibull law whose 1 / shape is `k`, plus 1.
double weibull_moment_ratio(double k)
{
    return std::exp(std::lgamma(1.0 + 2.0 * k) - 2.0 * std::lgamma(1.0 + k));
}

Distribution weibull_from_moments(double mean, double sd)
{
    const double wanted = 1.0 + (sd / mean) * (sd / mean);
    double lo = 1e-8;
    double hi = 1.0;
    while (weibull_moment_ratio(hi) < wanted) hi *= 2.0;
    for (int i = 0; i < 200 && hi - lo > 1e-15 * hi; ++i) {
        const double k = 0.5 * (lo + hi);
        (weibull_moment_ratio(k) < wanted ? lo : hi) = k;
    }
    const double k = 0.5 * (lo + hi);
    return {Law::weibull, std::log(mean) - std::lgamma(1.0 + k), k};
}

double standardised(const Distribution& d, double x)
{
    return ((positive(d.law) ? std::log(x) : x) - d.location) / d.dispersion;
}

} // namespace

std::string_view name(Law law) { return kNames[static_cast<std::size_t>(law)]; }

std::optional<Law> law(std::string_view name)
{
    for (std::size_t i = 0; i < kNames.size(); ++i)
        if (kNames[i] == name) return static_cast<Law>(i);
    return std::nullopt;
}

Distribution from_moments(Law law, double mean, double sd)
{
    if (!(sd > 0.0) || !std::isfinite(sd) || !std::isfinite(mean))
        throw std::invalid_argument("moments: standard deviation must be positive, is " +
                                    std::to_string(sd));
    if (positive(law) && !(mean > 0.0))
        throw std::invalid_argument("moments: mean of a " + std::string(name(law)) +
                                    " law must be positive, is " + std::to_string(mean));
    const double cv = sd / mean;
    switch (law) {
    case Law::normal:
        return {law, mean, sd};
    case Law::gamma:
        return {law, std::log(mean), cv};
    case Law::weibull:
        return weibull_from_moments(mean, sd);
    case Law::lognormal:
        break;
    }
    const double variance = std::log1p(cv * cv);
    return {law, std::log(mean) - 0.5 * variance, std::sqrt(variance)};
}

double cdf(const Distribution& d, double x)
{
    if (positive(d.law) && x <= 0.0) return 0.0;
    switch (d.law) {
    case Law::weibull:
        return SmallestExtreme::cdf(standardised(d, x));
    case Law::gamma:
        return boost::math::gamma_p(shape(d), x / scale(d));
    default:
        return StandardNormal::cdf(standardised(d, x));
    }
}

double survival(const Distribution& d, double x)
{
    if (positive(d.law) && x <= 0.0) return 1.0;
    switch (d.law) {
    case Law::weibull:
        return SmallestExtreme::survival(standardised(d, x));
    case Law::gamma:
        return boost::math::gamma_q(shape(d), x / scale(d));
    default:
        return StandardNormal::survival(standardised(d, x));
    }
}

double quantile(const Distribution& d, double p)
{
    if (!(p > 0.0 && p < 1.0))
        throw std::invalid_argument("quantile: probability must be in (0, 1), is " +
                                    std::to_string(p));
    switch (d.law) {
    case Law::normal:
        return d.location + d.dispersion * StandardNormal::quantile(p);
    case Law::weibull:
        return std::exp(d.location + d.dispersion * SmallestExtreme::quantile(p));
    case Law::gamma:
        return scale(d) * boost::math::gamma_p_inv(shape(d), p);
    case Law::lognormal:
        break;
    }
    return std::exp(d.location + d.dispersion * StandardNormal::quantile(p));
}

double mean(const Distribution& d)
{
    switch (d.law) {
    case Law::normal:
        return d.location;
    case Law::gamma:
        return std::exp(d.location);
    case Law::weibull:
        return std::exp(d.location + std::lgamma(1.0 + d.dispersion));
    case Law::lognormal:
        break;
    }
    return std::exp(d.location + 0.5 * d.dispersion * d.dispersion);
}

double standard_deviation(const Distribution& d)
{
    switch (d.law) {
    case Law::normal:
        return d.dispersion;
    case Law::gamma:
        return mean(d) * d.dispersion;
    case Law::weibull:
        return mean(d) * std::sqrt(weibull_moment_ratio(d.dispersion) - 1.0);
    case Law::lognormal:
        break;
    }
    return mean(d) * std::sqrt(std::expm1(d.dispersion * d.dispersion));
}

double shape(const Distribution& d)
{
    return d.law == Law::gamma ? 1.0 / (d.dispersion * d.dispersion) : 1.0 / d.dispersion;
}

double scale(const Distribution& d)
{
    return d.law == Law::gamma ? std::exp(d.location) * d.dispersion * d.dispersion
                               : std::exp(d.location);
}

} // namespace fragility
