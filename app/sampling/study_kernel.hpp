#pragma once
/// The correlation between joints that a study asks for.

#include "uq/fields/kernel.hpp"

namespace app {

struct StudyFile;
struct UqInput;

/// For Spatial::correlated.
/// @throws ConfigError if lengths are missing or too many
[[nodiscard]] uq::Kernel kernel_of(const UqInput& uq, const StudyFile& source);

} // namespace app
