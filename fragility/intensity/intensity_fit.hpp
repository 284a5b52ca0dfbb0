#pragma once
/// Fragility on the intensity of an earthquake: walls shaken by records at one or several
/// intensities. Three ways to a lognormal curve, and intervals that know that histories share
/// their records and their walls.

#include "core/interval.hpp"
#include "fragility/fits/observation.hpp"
#include "fragility/intensity/cloud.hpp"
#include "fragility/limits/model_outcome.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace fragility {

/// One wall under one record at one intensity.
struct ShakenWallPoint {
    std::size_t wall, record;
    double intensity; ///< [any unit], > 0
    double response;  ///< [any unit], >= 0; of a wall that fell, as far as it was seen
    bool fell;
};

enum class IntensityMethod {
    stripes, ///< reached or not, at each intensity: a binomial likelihood (Baker 2015)
    ida,     ///< intensity at which each wall under each record first reaches the state
    cloud ///< response against intensity; a wall that fell lies above what was seen (Tobin 1958)
};

/// P(state | x) = Phi(ln(x / median) / dispersion).
struct IntensityFit {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason; ///< why there is no curve
    IntensityCurve curve{};
    double n = 0.0;       ///< histories; of IDA walls under a record
    double reached = 0.0; ///< of these, the state; of IDA below the largest intensity
};

/// @param threshold of the response, > 0; infinite: collapse itself, of which a cloud is what
/// stripes are
/// @param least responses below are known to lie below it: a wall that stays elastic [unit of
/// the response], > 0
[[nodiscard]] IntensityFit fit_intensity(IntensityMethod method,
                                         std::span<const ShakenWallPoint> points,
                                         double threshold, double least);

/// One wall under one record: the intensity of its capacity.
struct PairCapacity {
    std::size_t wall, record;
    Observation capacity; ///< [unit of the intensity]
};
/// In the order of walls, then records.
[[nodiscard]] std::vector<PairCapacity> pair_capacities(std::span<const ShakenWallPoint> points,
                                                        double threshold);

/// A fit with its doubt.
struct ClusteredFit {
    IntensityFit fit;
    std::size_t records = 0, walls = 0;
    bool crossed = false; ///< walls share records and records share walls
    /// Standard errors of ln median; NaN: not known.
    double record_error = 0.0, wall_error = 0.0;
    /// An end that is not known is 0 or infinite.
    core::Interval median{}, dispersion{};
    std::string reason; ///< why there are no intervals; empty: there are
};

/// Intervals by the jackknife over clusters: the fit is repeated without each record, and
/// without each wall. The variances of both are added, which counts their interaction twice and
/// errs on the wide side (two-way clustering of Cameron, Gelbach & Miller 2011, J. Bus. Econ.
/// Stat. 29, without its last term). Quantiles are those of Student's law with the freedom that
/// both have together (Satterthwaite 1946). Where each wall has one record, or there is one
/// wall, only records are left out: walls are then part of them, or no sample.
/// @param confidence in (0, 1)
[[nodiscard]] ClusteredFit fit_clustered(IntensityMethod method,
                                         std::span<const ShakenWallPoint> points,
                                         double threshold, double least,
                                         double confidence = 0.95);

} // namespace fragility
