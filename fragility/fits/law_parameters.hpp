#pragma once
/// The parameters by which a law is known elsewhere, with their standard errors.

#include "fragility/fits/censored_fit.hpp"

#include <string_view>

namespace fragility {

struct LawParameter {
    std::string_view name; ///< "shape"
    double value = 0.0;
    double std_error = 0.0; ///< delta method, same unit as the value
};

/// Lognormal: ln median and dispersion. Normal: mean and standard deviation. Weibull and gamma:
/// shape and scale.
struct LawParameters {
    LawParameter first, second;
    double correlation = 0.0; ///< of both estimates
};

/// @throws std::invalid_argument if the fit has not converged
[[nodiscard]] LawParameters law_parameters(const Fit& fit);

} // namespace fragility
