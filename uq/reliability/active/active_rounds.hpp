#pragma once
/// Parts of the rounds that active_learning and active_quantile have in common.

#include "uq/reliability/active/doubtful_points.hpp"

#include <Eigen/Core>

#include <cstdint>

namespace uq {

/// First points, spread wider than the standard normal distribution.
[[nodiscard]] Eigen::MatrixXd first_design(Eigen::Index dimension, std::uint64_t seed);

/// Points of the process at which its own error is a third of the target.
[[nodiscard]] Eigen::Index active_points(double target_cov);

/// Whether learning saves more checks than it costs: they go with the square of the doubt.
/// @param needed checks @param gain share of the doubt that the next batch takes away
[[nodiscard]] bool learning_pays(double needed, double gain, Eigen::Index batch);

/// Checks that the target would need, if the process is right.
/// @param variance of a check, as the process expects it
[[nodiscard]] double needed_checks(double probability, double variance, double target_cov);

/// Change of ln P from one process to the next above which neither is worth a check; tuned.
constexpr double kSettled = 0.4;

} // namespace uq
