#pragma once
/// How strongly a response goes with one input (the paper, Fig. 12).
///
/// A row with NaN in the response or an input is a failed sample: left out and counted.

#include "core/interval.hpp"
#include "uq/estimates/estimate.hpp"

#include <Eigen/Core>

#include <optional>

namespace uq {

/// Inputs and response of the samples that answered.
struct SoundRows {
    Eigen::MatrixXd x;
    Eigen::VectorXd y;
    std::size_t failed;
};
/// @throws std::invalid_argument if the lengths differ or a value is infinite
[[nodiscard]] SoundRows sound_rows(const Eigen::MatrixXd& x, const Eigen::VectorXd& y);

/// 1 .. n in ascending order, equal values share the mean of their ranks.
[[nodiscard]] Eigen::VectorXd ranks(const Eigen::VectorXd& y);

/// Linear correlation (Pearson). The interval is that of Fisher's z, for normal pairs. Nothing
/// is returned if x or y does not vary.
/// @throws std::invalid_argument as sound_rows, for fewer than 4 sound rows or a confidence
/// outside (0, 1)
[[nodiscard]] std::optional<Estimate>
pearson(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double confidence = kConfidence);

/// Monotonic correlation (Spearman): the Pearson correlation of the ranks. Interval by Fisher's
/// z with the variance (1 + r^2 / 2) / (n - 3) (Bonett and Wright 2000).
[[nodiscard]] std::optional<Estimate>
spearman(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double confidence = kConfidence);

/// The variance of z of a correlation of ranks grows by this with r^2 (Bonett and Wright 2000).
constexpr double kRankVariance = 0.5;

/// Interval of a correlation `r` through Fisher's z; `z_error`: standard error of z.
[[nodiscard]] core::Interval fisher_interval(double r, double z_error, double confidence);

} // namespace uq
