#pragma once
/// Samples drawn around design points and weighed back (Melchers 1989).

#include "uq/reliability/limit_state/exceedance.hpp"

namespace uq {

struct ImportanceOptions {
    std::size_t batch = 500;         ///< samples asked for at a time, >= 1
    std::size_t max_samples = 20000; ///< >= 1
    double target_cov = 0.05; ///< stops at a batch that reaches it without a warning, > 0
    /// Share of samples drawn around the origin instead, wide enough to reach the radius of the
    /// nearest design point in every direction: the part of the limit state that no design
    /// point leads to is then seen, and no weight is large. [0, 1)
    double defensive = 0.2;
    double confidence = 0.95; ///< of the interval, (0, 1)
    std::uint64_t seed = 1;
};

struct ImportanceResult {
    Exceedance exceedance;
    double effective = 0.0;     ///< (sum w)^2 / sum w^2 of passed samples
    double largest_share = 0.0; ///< of the sum of weights, in one sample
    /// Share of the probability in passed samples that lie less than halfway to every centre,
    /// measured along its radius: other branches, that no centre leads to.
    double unexplained_share = 0.0;
};

/// With fewer effective samples the standard error itself is uncertain, and a warning says so.
/// Tuned, see tests.
constexpr double kFewEffective = 50.0;
/// A larger share of the sum in one weight causes a warning.
constexpr double kLargeShare = 0.1;
/// A larger share away from all centres causes a warning: look for more design points.
constexpr double kUnexplainedShare = 0.05;

/// Mixture of unit normal densities at the centres, weighed by Phi(-|centre|), and the
/// defensive one. @param centres design points, one row each, at least one
/// @throws std::invalid_argument naming what is out of range
[[nodiscard]] ImportanceResult importance_sampling(const LimitState& s,
                                                   const Eigen::MatrixXd& centres,
                                                   const ImportanceOptions& o = {});

} // namespace uq
