#pragma once
/// Reading a capacity curve: peak, secant stiffness, displacement at which the force falls to a
/// share of the peak.
///
/// Any consistent unit. Between two points the curve is a straight line; a step (two points at
/// one displacement) is allowed. A curve that starts at a displacement above zero is led there
/// from the origin by a straight line.

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace fragility {

/// A view of one monotonic push. A push in the other direction is mirrored by the caller.
struct Curve {
    std::span<const double> displacement; ///< [length], >= 0, never decreasing, finite
    std::span<const double> force;        ///< [force], finite, one for each displacement
    bool came_down =
        false; ///< the curve ends because the wall came down: no force is left there
};

/// @throws std::invalid_argument naming the point, if the curve is empty or breaks a rule of
/// Curve. Every function below that takes a curve begins with it.
void check(const Curve& curve);

struct Peak {
    double force = 0.0;
    double displacement = 0.0; ///< the first at which the force is reached
    bool at_end = false;       ///< the curve still rises where it ends: a lower bound
};

[[nodiscard]] Peak peak(const Curve& curve);

/// First displacement at which the force reaches `force`; nothing if it never does.
[[nodiscard]] std::optional<double> first_reaching(const Curve& curve, double force);

/// Area under the curve from zero to `displacement` [force x length].
/// @throws std::invalid_argument if `displacement` is not within [0, last displacement]
[[nodiscard]] double area(const Curve& curve, double displacement);

/// Share of the peak for the secant stiffness: our choice. A wall without tensile strength is
/// linear until its base opens (middle third), at a third of its rigid rocking load, and its
/// peak is at most that load: 0.30 is inside the linear range and clear of the seating.
constexpr double kSecantShare = 0.30;
/// The share of the EPFL Stone Masonry Database (Vanin, Zaganelli, Penna, Beyer 2017), to
/// compare with its K_el.
constexpr double kSecantShareDatabase = 0.15;

/// Force / displacement where the force first reaches `share` of the peak [force / length].
/// Nothing if the force is nowhere positive, or already there at zero displacement.
/// @param share in (0, 1], else std::invalid_argument
[[nodiscard]] std::optional<double> secant_stiffness(const Curve& curve,
                                                     double share = kSecantShare);

/// Worth of a displacement read off a curve.
enum class Reading {
    observed,   ///< it happens at `displacement`
    censored,   ///< it has not happened up to `displacement` (right-censored)
    not_defined ///< the curve has no such point; `displacement` is 0 and means nothing
};

/// Names in the order of Reading.
inline constexpr std::array<std::string_view, 3> kReadingNames = {"observed", "censored",
                                                                  "not defined"};
[[nodiscard]] constexpr std::string_view name(Reading reading)
{
    return kReadingNames[static_cast<int>(reading)];
}

struct LimitDisplacement {
    double displacement = 0.0; ///< [length], finite
    Reading reading = Reading::not_defined;
    /// Why it is not observed, or what an observed value leans on; else empty.
    std::string_view reason;
};

[[nodiscard]] constexpr bool is_observed(const LimitDisplacement& d)
{
    return d.reading == Reading::observed;
}
[[nodiscard]] constexpr bool is_censored(const LimitDisplacement& d)
{
    return d.reading == Reading::censored;
}
[[nodiscard]] constexpr bool is_defined(const LimitDisplacement& d)
{
    return d.reading != Reading::not_defined;
}

/// Jerky curves cross a level many times.
enum class Crossing {
    first, ///< the force first comes down to the level
    last ///< the force comes down to the level for good; a curve that ends above it never does
};

/// Share of the peak: the paper, section 4.2; Circolare 7/2019, C8.7.1.3.1.
constexpr double kUltimateShare = 0.80;

/// Displacement after the first peak at which the force comes down to `share` of it. Touching
/// the level counts, and so does a wall that came down: where its curve ends, at the latest.
/// @param share in [0, 1); 0: no force is left; else std::invalid_argument
[[nodiscard]] LimitDisplacement drop_after_peak(const Curve& curve,
                                                double share = kUltimateShare,
                                                Crossing crossing = Crossing::first);

/// Range of a drop whose peak is known to a share of it.
struct DropRange {
    LimitDisplacement earliest, latest; ///< [length]; not defined where the share is not known
};

/// The drop to `share` of a peak that is higher by `error`, and of one that is lower. A curve
/// that touches the level and turns back has its two ends far apart.
/// @param error of the peak force, as a share of it [-], >= 0; NaN: not known
[[nodiscard]] DropRange drop_range(const Curve& curve, double share, Crossing crossing,
                                   double error);

} // namespace fragility
