#pragma once
/// The correlation between joints that a study asks for.

#include "uq/fields/kernel.hpp"

namespace app {

struct Study;

/// For Spatial::correlated.
/// @throws ConfigError if lengths are missing or too many
[[nodiscard]] uq::Kernel kernel_of(const Study& study);

} // namespace app
