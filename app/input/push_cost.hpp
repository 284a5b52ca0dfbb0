#pragma once
/// Cost of a push before it begins.

#include "dem/block/discretisation.hpp"
#include "dem/scene/layout.hpp"
#include "dem/solver/state/solver_options.hpp"

namespace app {

struct LoadInput;

/// Updates of contacts that a push to its end is likely to take: steps of its fastest drive,
/// and more the less error it bears. A push that ends once its limits are known takes fewer;
/// one that has to be repeated more slowly takes more.
[[nodiscard]] double expected_updates(const LoadInput& load,
                                      const dem::Discretisation& discretisation,
                                      const dem::SolverOptions& solver,
                                      const dem::Layout& layout);

/// Updates of one core in a second, pushing one wall [1/s]: a processor of 2021.
inline constexpr double kUpdatesPerSecond = 2.5e7;

} // namespace app
