#pragma once
/// Mean of an expensive quantity, helped by cheap ones of unknown mean: multi-fidelity Monte
/// Carlo (Peherstorfer, Willcox, Gunzburger 2016, eq. 3.4).

#include "uq/estimates/estimate.hpp"

#include <Eigen/Core>

#include <vector>

namespace uq {

/// y[0] holds the expensive values of samples 0 .. n_0 - 1, y[i] those of cheap model i of
/// samples 0 .. n_i - 1, n_0 <= n_1 <= ... All finite.
using NestedValues = std::vector<Eigen::VectorXd>;

struct ControlledMean {
    Estimate estimate{};
    Eigen::VectorXd coefficient; ///< of each cheap model: cov(expensive, cheap) / var(cheap)
    Eigen::VectorXd
        correlation;        ///< of each with the expensive one, over the n_0 shared samples
    double plain_std_error; ///< of the mean of the expensive values alone
};

///   mean(y_0) + sum_i a_i (mean of y_i over n_i - mean of y_i over n_(i-1))
/// less the bias of its estimated coefficients by the jackknife (Quenouille 1956). The standard
/// error is that of the jackknife over the expensive samples, which counts the doubt about the
/// coefficients, and the variance of the further samples of each cheap model. The interval is
/// Student's.
/// @throws std::invalid_argument for fewer than 3 expensive values, sizes that fall, values not
/// finite, or a confidence outside (0, 1)
[[nodiscard]] ControlledMean controlled_mean(const NestedValues& y, double confidence = 0.95);

} // namespace uq
