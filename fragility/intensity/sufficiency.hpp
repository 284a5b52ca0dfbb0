#pragma once
/// Sufficiency of a measure of intensity (Luco & Cornell 2007, Earthquake Spectra 23): given
/// the measure, does the response still depend on another feature of the record?

#include "fragility/intensity/cloud.hpp"
#include "fragility/limits/model_outcome.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace fragility {

/// Fewest records of a test: with fewer it hardly ever rejects.
constexpr std::size_t kSufficiencyRecords = 8;

struct SufficiencyTest {
    ModelOutcome outcome = ModelOutcome::no_data;
    std::string reason; ///< why there is no p-value
    double p = 1.0;     ///< two-sided: small where the measure is not sufficient
};

/// Score test of a further term c ln(feature) in the line of `fit`. Scores are summed over each
/// record, because histories of one record share it; their sum over the root of the sum of
/// their squares is taken for Student's t with two degrees of freedom less than there are
/// records. Under a true line it rejects at 5 % in 2 to 6 of 100 cases, and in up to 9 where
/// the feature goes along with the measure.
/// @param feature ln of it, by point
/// @param record by point
/// @throws std::invalid_argument where these are not as many as the points
[[nodiscard]] SufficiencyTest test_sufficiency(std::span<const CloudPoint> points,
                                               const CloudFit& fit,
                                               std::span<const double> feature,
                                               std::span<const std::size_t> record);

} // namespace fragility
