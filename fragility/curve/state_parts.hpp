#pragma once
/// Displacements that limit states of codes and of users are made of.

#include "fragility/curve/curve_reading.hpp"

#include <string_view>

namespace fragility {

/// First rise to a share of the peak force.
[[nodiscard]] LimitDisplacement rise_to(const Curve& curve, double share);

/// Displacement at the peak; censored where the curve still rises.
[[nodiscard]] LimitDisplacement at_peak(const Peak& top);

/// The largest displacement allowed: reached where the curve gets so far.
/// @param governs reason where it is reached
[[nodiscard]] LimitDisplacement cap_alone(const Curve& curve, double cap,
                                          std::string_view governs);

/// The same beside another rule: whichever comes first.
[[nodiscard]] LimitDisplacement capped(const Curve& curve, const LimitDisplacement& limit,
                                       double cap, std::string_view governs);

} // namespace fragility
