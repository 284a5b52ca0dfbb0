#pragma once
/// Correlation between the random inputs of a study: uq.pearson.

#include "app/input/study.hpp"
#include "uq/designs/normal_copula.hpp"

#include <optional>

namespace app {

/// The dependence of the inputs through the normal copula; nothing if all are independent.
/// @throws ConfigError if uq.pearson names something that is not a random input, or asks for a
/// correlation that cannot be had; in a spatial study also if it joins inputs that do not vary
/// over the same joints
[[nodiscard]] std::optional<uq::NormalCopula> dependence_of(const Study& study);

} // namespace app
