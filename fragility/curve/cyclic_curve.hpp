#pragma once
/// Reading the path of a push to and fro: its cycles, and the backbone of each direction.
///
/// Any consistent unit; displacements from the undeformed wall, of either sign. Between two
/// points the path is a straight line.

#include "fragility/curve/curve_reading.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace fragility {

/// A view of one push that may turn back.
struct Path {
    std::span<const double> displacement; ///< [length], finite, from 0
    std::span<const double> force;        ///< [force], finite, one for each displacement
};

/// One cycle: it begins at zero displacement, visits one side or both, and ends where the path
/// comes back to zero to begin the next one, or where the path ends.
struct Cycle {
    std::size_t begin = 0, end = 0; ///< first and last point of the path
    /// Share of the way from `begin`, and from `end`, to the next point at which the path
    /// passes zero displacement [-]; 0: it is there, or does not pass.
    double begin_share = 0.0, end_share = 0.0;
    bool closed = false; ///< the path came back to zero displacement, to 0.5 % of its width
    /// On one side the path came back and went out again, by more than 2 % of its width each.
    bool inner_loop = false;
    double displacement_plus = 0.0,
           displacement_minus = 0.0;            ///< extremes, >= 0 and <= 0 [length]
    double force_plus = 0.0, force_minus = 0.0; ///< largest and smallest force, >= 0 and <= 0
    double force_at_plus = 0.0, force_at_minus = 0.0; ///< at the extremes of displacement
    /// Work done in the cycle, from zero displacement to zero: the area of its loop [force x
    /// length].
    double energy = 0.0;
    /// Where the force comes back to zero after the extreme, if need be on the way into the
    /// next cycle; nothing where the path does not unload.
    std::optional<double> residual_plus, residual_minus;
};

/// @throws std::invalid_argument if the lengths differ or a value is not finite
[[nodiscard]] std::vector<Cycle> cycles(const Path& path);

/// Half the distance of both extremes; of a cycle to one side its extreme.
[[nodiscard]] double amplitude(const Cycle& cycle);

/// Equivalent viscous damping: energy / (2 pi F d), with F d the mean of both sides (Jacobsen;
/// Priestley, Calvi and Kowalsky 2007, Eq. 3.15). A cycle of one side counts as half a
/// symmetric one. Nothing where the cycle is not closed, has an inner loop, whose energy is of
/// another amplitude, or F d is not positive.
[[nodiscard]] std::optional<double> equivalent_damping(const Cycle& cycle);

/// Slope of the line between both extremes [force / length]; nothing where the cycle has no
/// width.
[[nodiscard]] std::optional<double> secant_stiffness(const Cycle& cycle);

/// Displacement and force of one direction, both positive in it; never decreasing
/// displacements, from the origin.
struct Backbone {
    std::vector<double> displacement, force;
};

/// The envelope of first cycles: the parts of the path that lie farther out than all before
/// (envelope curve of ASTM E2126). Cycles that repeat an amplitude add nothing. Beyond the
/// amplitude before, a cycle first loads what is there already: up to its largest force, points
/// below the straight line from the point before to it are left out. A force that stays below
/// is a step.
/// @param direction 1 or -1, else std::invalid_argument
[[nodiscard]] Backbone backbone(const Path& path, int direction);

/// Mean of the forces of both, as far as both reach; steps stay.
[[nodiscard]] Backbone mean(const Backbone& a, const Backbone& b);

/// The curve on which limit displacements of a push to and fro are read.
enum class Side {
    mean,  ///< the mean of both backbones
    worse, ///< either backbone: of both displacements the smaller
    right, ///< the backbone of displacements > 0
    left
};

/// Names in the order of Side.
inline constexpr std::array<std::string_view, 4> kSideNames = {"mean", "worse", "right",
                                                               "left"};

/// The displacement of two directions that comes first: not observed where it may come after
/// the end of the other's curve, not defined where one is not.
[[nodiscard]] LimitDisplacement worse(const LimitDisplacement& a, const LimitDisplacement& b);

} // namespace fragility
