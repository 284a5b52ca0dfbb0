#pragma once
/// Cost of a push before it begins.

#include "dem/scene/layout.hpp"

namespace app {

struct Study;

/// Updates of contacts that a push to its end is likely to take: steps of its fastest drive,
/// and more the less error it bears. A push that ends once its limits are known takes fewer;
/// one that has to be repeated more slowly takes more.
[[nodiscard]] double expected_updates(const Study& study, const dem::Layout& layout);

/// Updates of one core in a second, pushing one wall [1/s]: a processor of 2021.
inline constexpr double kUpdatesPerSecond = 2.5e7;

} // namespace app
