#pragma once
/// The first loading of each direction of a push: where its force is zero, and how far it goes.

#include "fragility/curve/cyclic_curve.hpp"

namespace fragility {

/// How a direction is loaded for the first time, mostly on the way from the other one.
struct FirstLoading {
    /// From where the force is zero to zero displacement [length]; negative where the force of
    /// the wall at rest acts with the push.
    double residual = 0.0;
    /// Left at zero displacement by the way to the other side: the force there in that
    /// direction, less that of the wall at rest [force], >= 0.
    double force = 0.0;
    /// Farthest displacement before the wall first comes from the other side with more of that
    /// force than it may; 0 where it does so at once [length].
    double reach = 0.0;
    double turn = 0.0; ///< farthest displacement before the first turn back [length]
};

/// A wall that is not symmetric is held by a force where it has no displacement: the first one
/// of the path.
/// @param most force left at zero displacement that may be there [force], >= 0
/// @param direction 1 or -1, else std::invalid_argument
[[nodiscard]] FirstLoading first_loading(const Path& path, int direction, double most);

/// FirstLoading::residual of a curve that begins at rest. Where the force does not pass zero it
/// goes on to it along the secant over the first twentieth of its rise.
[[nodiscard]] double residual_at_rest(const Curve& curve);

/// A backbone counted from where the force was zero before it began.
[[nodiscard]] Backbone from_own_zero(const Curve& curve, double residual);

/// A share of the peak, or that which the curve reaches up to a displacement if that is less:
/// beyond, a stiffness would not be that of first loading.
/// @param reach such as FirstLoading::reach; 0: the whole curve
[[nodiscard]] double share_within(const Curve& curve, double reach, double share);

} // namespace fragility
