#pragma once
/// Two heaps of values where one law is supposed: the alternative that a distance from the law
/// sees late.

#include "fragility/observation.hpp"

#include <span>

namespace fragility {

/// Twice the gain in classification likelihood (Symons 1981, Biometrics 37, 35-43) if the
/// values, in their order, are parted into two normal heaps instead of one: the largest over
/// all partings with three values or more on either side. A heap is not narrower than a tenth
/// of all values. Fewer than six values, or one that is not observed: 0; never below 0.
/// @param positive parts the logarithms
/// @param data positive values if `positive`
[[nodiscard]] double two_heaps(std::span<const Observation> data, bool positive);

} // namespace fragility
