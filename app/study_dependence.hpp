#pragma once
/// Correlation between the random inputs of a study: uq.pearson.

#include "app/study.hpp"

#include <Eigen/Core>

namespace app {

/// Lower factor of the correlation of the inputs' standard normal coordinates (Nataf); empty if all
/// are independent.
/// @throws ConfigError if uq.pearson names what is no random input, or cannot be had
[[nodiscard]] Eigen::MatrixXd mixing_of(const Study& study);

} // namespace app
