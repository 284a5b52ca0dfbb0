#include "fragility/fits/law_parameters.hpp"

#include <cmath>
#include <stdexcept>

namespace fragility {

/// J C J' to first order, with C of (location, ln dispersion).
LawParameters law_parameters(const Fit& fit)
{
    if (fit.outcome != FitOutcome::converged)
        throw std::invalid_argument("law parameters: the fit has not converged");
    const Distribution& law = fit.law;
    Eigen::Matrix2d j = Eigen::Matrix2d::Identity();
    LawParameters p;
    if (law.law == Law::lognormal || law.law == Law::normal) {
        const bool normal = law.law == Law::normal;
        p.first = {normal ? "mean" : "ln median", law.location};
        p.second = {normal ? "std deviation" : "dispersion", law.dispersion};
        j(1, 1) = law.dispersion;
    } else {
        p.first = {"shape", shape(law)};
        p.second = {"scale", scale(law)};
        const bool weibull = law.law == Law::weibull;
        // Weibull: shape = 1 / dispersion, scale = exp(location);
        // gamma: shape = 1 / dispersion^2, scale = exp(location) dispersion^2
        j << 0.0, -(weibull ? 1.0 : 2.0) * p.first.value, p.second.value,
            (weibull ? 0.0 : 2.0) * p.second.value;
    }
    const Eigen::Matrix2d v = j * fit.covariance * j.transpose();
    p.first.std_error = std::sqrt(v(0, 0));
    p.second.std_error = std::sqrt(v(1, 1));
    p.correlation = v(0, 1) / (p.first.std_error * p.second.std_error);
    return p;
}

} // namespace fragility
