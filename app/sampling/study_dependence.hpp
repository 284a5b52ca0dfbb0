#pragma once
/// Correlation between the random inputs of a study: uq.pearson.

#include "app/input/study.hpp"
#include "uq/designs/inputs.hpp"

#include <optional>

namespace app {

/// The inputs with their correlation through the normal copula; nothing if all are independent.
/// @throws ConfigError if uq.pearson names what is no random input, or cannot be had; in a spatial study
/// also if it joins inputs that do not vary over the same joints
[[nodiscard]] std::optional<uq::JointDistribution> dependence_of(const Study& study);

} // namespace app
