#include "fragility/laws/law.hpp"

#include "fragility/laws/standard_law.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace fragility {
namespace {

constexpr std::array<std::string_view, 4> kLawNames{"lognormal", "normal", "weibull", "gamma"};

double standardised(const Distribution& d, double x)
{
    return ((positive(d.law) ? std::log(x) : x) - d.location) / d.dispersion;
}

} // namespace

std::string_view name(Law law) { return kLawNames[static_cast<std::size_t>(law)]; }

std::optional<Law> law(std::string_view name)
{
    for (std::size_t i = 0; i < kLawNames.size(); ++i)
        if (kLawNames[i] == name) return static_cast<Law>(i);
    return std::nullopt;
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
