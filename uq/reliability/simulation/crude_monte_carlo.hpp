#pragma once
/// Share of independent samples that pass the limit state.

#include "uq/reliability/limit_state/exceedance.hpp"

namespace uq {

struct MonteCarloOptions {
    std::size_t batch = 1000;         ///< samples asked for at a time, >= 1
    std::size_t max_samples = 100000; ///< >= 1
    /// Sampling stops after the first batch at which the coefficient of variation is at most
    /// this, > 0.
    double target_cov = 0.05;
    double confidence = 0.95; ///< of the interval, (0, 1)
    std::uint64_t seed = 1;
};

/// Sample i is keyed by (seed, i), so that a longer run begins with the samples of a shorter
/// one. Stopping on the result causes a bias of the order of target_cov^2, which is small
/// against the standard error.
/// @throws std::invalid_argument naming the option that is out of range
[[nodiscard]] Exceedance crude_monte_carlo(const LimitState& s,
                                           const MonteCarloOptions& o = {});

/// Independent standard normal rows of samples first .. first + n - 1.
[[nodiscard]] Eigen::MatrixXd normal_rows(std::uint64_t seed, std::size_t first, std::size_t n,
                                          Eigen::Index dimension);

} // namespace uq
