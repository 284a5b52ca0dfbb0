#pragma once
/// A factor on limit drifts or forces for the error of the model, and what it makes of their
/// quantiles.

#include "core/interval.hpp"
#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/laws/law.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace fragility {

/// A lognormal factor, test over prediction. The default is none: it changes nothing.
struct ModelFactor {
    double median = 1.0; ///< [-], > 0
    double dispersion =
        0.0; ///< standard deviation of its logarithm, from wall to wall [-], >= 0
    double median_error = 0.0; ///< standard error of ln median [-], >= 0
};

/// sqrt(dispersion^2 + median_error^2): of a further wall.
[[nodiscard]] inline double model_dispersion(const ModelFactor& factor)
{
    return std::hypot(factor.dispersion, factor.median_error);
}

/// The drifts of the walls, as values that share the probability. Some of it may lie beyond the
/// largest drift that was tested.
struct DriftDistribution {
    std::vector<double> drifts;  ///< ascending, > 0 [x]
    std::vector<double> weights; ///< of each, > 0; their sum and `beyond` are 1
    double beyond = 0.0;         ///< probability of drifts above `end` [-]
    double end = 0.0;            ///< [x]; used where beyond > 0
};
[[nodiscard]] DriftDistribution drift_distribution(const KaplanMeier& observed);
/// A law as 1000 values of equal probability; of laws that reach below 0 the positive part.
[[nodiscard]] DriftDistribution drift_distribution(const Distribution& law);

/// Smallest and largest value that a quantile can have; apart where it depends on what lies
/// beyond the largest drift tested.
struct QuantileBounds {
    double lower, upper; ///< [x]; upper may be infinite
};
/// Quantile of drift times a lognormal factor of this median and dispersion.
/// @param dispersion >= 0; 0: the drifts scaled  @param p in (0, 1)
[[nodiscard]] QuantileBounds factored_quantile(const DriftDistribution& walls, double median,
                                               double dispersion, double p);

/// Standard deviations of the logarithm [-]; NaN: the walls do not tell.
struct Dispersions {
    double material; ///< from wall to wall in the model: half of ln(84 % / 16 % drift)
    double sampling; ///< error of ln median by the number of walls
    double model;    ///< of the factor with its median
    double total;    ///< root of the sum of squares
};
[[nodiscard]] Dispersions dispersions(double material, double sampling,
                                      const ModelFactor& factor);

/// A limit drift, or a force, with the doubt of the model.
struct DoubtedLimit {
    /// 16, 50, 84 % [x], of a further wall; a lower end of 0: not known
    std::array<QuantileBounds, 3> quantiles{};
    core::Interval median_interval{}; ///< of the median: sampling and the median of the factor
    Dispersions dispersion{};
};

/// The one place where the factor meets the quantiles.
/// @param median interval of the median of the walls; an end of 0 or infinity: not known
/// @param sampling standard error of ln median; NaN: from that interval
[[nodiscard]] DoubtedLimit with_model_doubt(const DriftDistribution& walls,
                                            const core::Interval& median, double sampling,
                                            const ModelFactor& factor);
/// The same where one law describes the walls. A lognormal one stays lognormal: in ln x the
/// deviate of a further wall is hypot(t s sqrt(1 + 1/n), z model), s sqrt(1 + 1/n) being
/// material and sampling together and t Student's quantile.
/// @param freedom degrees of freedom of the dispersion of a lognormal law, > 0; infinite: z
[[nodiscard]] DoubtedLimit with_model_doubt(const Distribution& law,
                                            const core::Interval& median, double sampling,
                                            const ModelFactor& factor,
                                            double freedom = core::kInfinity);
/// Where nothing but a lower bound of the walls' median is known: that bound times the median
/// of the factor, and no 16 and 84 %.
/// @param above the bound [x], > 0
[[nodiscard]] DoubtedLimit bounded_with_model_doubt(double above, double confidence,
                                                    const ModelFactor& factor);

} // namespace fragility
