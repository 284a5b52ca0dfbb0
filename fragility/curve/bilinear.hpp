#pragma once
/// Equal-energy bilinear: the elastic-perfectly plastic curve that stands for a capacity curve.

#include "fragility/curve/curve_reading.hpp"

#include <string_view>

namespace fragility {

constexpr double kBilinearShare = 0.60; ///< of the peak: Circolare 7/2019, C7.3.4.2
/// Gives yield drifts near those of the EPFL Stone Masonry Database (Vanin, Zaganelli, Penna,
/// Beyer 2017); how near: tests/fragility/tested/test_measured_walls.cpp.
constexpr double kBilinearShareDatabase = 0.70;

enum class BilinearOutcome {
    found,
    no_positive_force,     ///< nothing to idealise
    no_elastic_branch,     ///< the share of the peak is carried at zero displacement
    ultimate_before_share, ///< the share of the peak is reached after the ultimate displacement
    no_positive_area,      ///< no energy up to the ultimate displacement
    no_real_root           ///< more energy than a straight elastic branch holds: it stiffens
};

/// Plain words for an outcome; empty for `found`.
[[nodiscard]] std::string_view reason(BilinearOutcome outcome);

/// All values are 0 unless the outcome is `found`.
struct Bilinear {
    BilinearOutcome outcome = BilinearOutcome::no_positive_force;
    double stiffness = 0.0;             ///< of the elastic branch [force / length], > 0
    double yield_displacement = 0.0;    ///< [length], in (0, ultimate]
    double yield_force = 0.0;           ///< plateau [force], > 0
    double ultimate_displacement = 0.0; ///< where the plateau ends [length]
    double ductility = 0.0;             ///< ultimate / yield displacement [-], >= 1
};

/// Elastic branch through the first point at `share` of the peak, plateau by equal areas up to
/// the ultimate displacement d_u:
///   k = share V / d(share V)
///   k d_y (d_u - d_y / 2) = E(d_u),   d_y = d_u - sqrt(d_u^2 - 2 E / k)
/// @param ultimate  d_u, within [0, last displacement], else std::invalid_argument
/// @param share     in (0, 1], else std::invalid_argument
[[nodiscard]] Bilinear equal_energy_bilinear(const Curve& curve, double ultimate,
                                             double share = kBilinearShare);

} // namespace fragility
