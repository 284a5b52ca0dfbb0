#pragma once
/// Likelihood of one response of a cloud. Internal to fragility/intensity/.

#include "fragility/fits/observation.hpp"
#include "fragility/laws/standard_law.hpp"

namespace fragility {

/// ln likelihood of a normal z that is seen, or that lies above or below z.
[[nodiscard]] inline LogTerm cloud_term(Censoring kind, double z)
{
    return kind == Censoring::none    ? StandardNormal::log_density(z)
           : kind == Censoring::right ? StandardNormal::log_survival(z)
                                      : StandardNormal::log_cdf(z);
}

/// The response that is seen, or its bound.
[[nodiscard]] inline double bound_of(const Observation& o, Censoring kind)
{
    return kind == Censoring::left ? o.upper : o.lower;
}

} // namespace fragility
