#pragma once
/// True evaluations that check processes of a response, and the distribution function that they
/// make without bias.

#include "core/interval.hpp"
#include "uq/reliability/active/active_checks.hpp"

#include <optional>
#include <vector>

namespace uq {

/// The process of one round at its points, and the checks that were drawn from them.
struct QuantileRound {
    WeighedPoints points;
    CheckPlan plan;
    double shift;                   ///< response at which g of the points is 0
    double scale;                   ///< of asinh((y - shift) / scale); infinite: y - shift
    double noise;                   ///< variance, of g
    std::vector<Eigen::Index> rows; ///< of the points, one for each check
    std::vector<double> y;          ///< what they answered; NaN: failed
};

/// Interval of P(y <= t), and its estimate.
struct ProbabilityBelow {
    double value;
    double std_error;
    core::Interval interval; ///< failed checks above t at the lower end, below at the upper end
};

/// Probability that the process gives to y <= t, over its points.
[[nodiscard]] double process_below(const QuantileRound& round, double t);

/// @param rounds with at least two sound checks in all
[[nodiscard]] ProbabilityBelow probability_below(const std::vector<QuantileRound>& rounds,
                                                 double t, double confidence);

/// Where the probability is crossed, and the nearest places on either side where it is not in
/// the interval. Each is nothing where it is not between `least` and `most`.
struct QuantileCrossing {
    std::optional<double> value, lower, upper;
};
[[nodiscard]] QuantileCrossing crossing(const std::vector<QuantileRound>& rounds,
                                        double probability, double least, double most,
                                        double confidence);

} // namespace uq
