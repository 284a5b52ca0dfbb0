#pragma once
/// Two heaps of values where one law is supposed: the alternative that a distance from the law
/// sees late.

#include "fragility/fits/observation.hpp"

#include <span>

namespace fragility {

/// The parting of values, in their order, into two heaps that says most.
struct Parting {
    double gain = 0.0;  ///< see two_heaps
    double last = 0.0;  ///< largest value of the lower heap [unit of the data]
    double apart = 0.0; ///< distance of the means over the sum of the standard deviations [-]
};
/// @param positive parts the logarithms
[[nodiscard]] Parting best_parting(std::span<const Observation> data, bool positive);

/// Twice the gain in classification likelihood (Symons 1981, Biometrics 37, 35-43) if the
/// values, in their order, are parted into two normal heaps instead of one: the largest over
/// all partings with three values or more on either side. A heap is not narrower than a tenth
/// of all values. Fewer than six values, or one that is not observed: 0; never below 0.
/// @param positive parts the logarithms
/// @param data positive values if `positive`
[[nodiscard]] double two_heaps(std::span<const Observation> data, bool positive);

} // namespace fragility
