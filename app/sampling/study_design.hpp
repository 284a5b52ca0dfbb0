#pragma once
/// The design that a study asks for, on the unit cube.

#include "app/input/study.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace app {

/// @param sizes through which the design has grown, increasing; the last: samples
/// @return samples x columns, in (0, 1)
/// @throws ConfigError if the design cannot have as many columns
[[nodiscard]] Eigen::MatrixXd unit_cube_of(const Study& study, int columns, std::uint64_t seed,
                                           std::span<const std::uint32_t> sizes);

} // namespace app
