#pragma once
/// Capacities from incremental dynamic analyses, and annual rates.

#include "fragility/fits/observation.hpp"

#include <span>
#include <vector>

namespace fragility {

/// One wall under one record at one intensity.
struct IdaStep {
    double intensity; ///< [any unit], > 0
    double response;  ///< [any unit], >= 0; of no meaning if collapsed
    bool collapsed;
};

/// Intensity at which a threshold is first exceeded. Between two steps that stood it is
/// interpolated along straight lines in both; before a collapse it lies between the last step
/// that stood below the threshold and the first collapse: a collapse has no response to
/// interpolate with. Never exceeded: above the last intensity.
/// @param steps ascending in intensity, at least one
/// @param threshold > 0; infinite: collapse itself
/// @throws std::invalid_argument
[[nodiscard]] Observation ida_capacity(std::span<const IdaStep> steps, double threshold);

/// A point of a hazard curve.
struct HazardPoint {
    double intensity; ///< > 0
    double rate;      ///< mean annual frequency of being exceeded [1/a], > 0
};

/// Annual rate of a limit state of a lognormal fragility: the integral of P(limit state | x)
/// over the falling hazard, which is a power law between points. Beyond the last point nothing
/// is known and the rate left there is added in full to `upper`, not at all to `lower`; below
/// the first point it is left out.
struct AnnualRate {
    double lower, upper;
};
/// @param hazard ascending in intensity, falling in rate, two points or more
/// @throws std::invalid_argument
[[nodiscard]] AnnualRate annual_rate(std::span<const HazardPoint> hazard, double median,
                                     double dispersion);

} // namespace fragility
