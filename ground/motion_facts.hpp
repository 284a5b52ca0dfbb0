#pragma once
/// Peaks of a motion, and what makes one unfit.

#include "ground/ground_motion.hpp"

#include <string>
#include <vector>

namespace ground {

/// The ground starts at rest. Velocity and displacement are sums by the trapezoidal rule, as in
/// the heads of records.
struct MotionFacts {
    double pga = 0.0;                ///< largest |acceleration| [m/s2]
    double pgv = 0.0;                ///< largest |velocity| [m/s]
    double pgd = 0.0;                ///< largest |displacement| [m]
    double duration = 0.0;           ///< [s]
    double final_velocity = 0.0;     ///< [m/s]
    double final_displacement = 0.0; ///< [m]
};

[[nodiscard]] MotionFacts motion_facts(const GroundMotion& motion);

struct Trace {
    std::vector<double> velocity;     ///< [m/s]
    std::vector<double> displacement; ///< [m]
};

/// At the samples.
[[nodiscard]] Trace integrated(const GroundMotion& motion);

inline constexpr double kMostFinalVelocity = 0.05; ///< of the PGV

/// Why a motion should not shake a wall: its velocity ends above a share of the PGV, so that
/// the ground would go on moving. Empty: nothing is wrong.
[[nodiscard]] std::string unfit_motion(const MotionFacts& facts,
                                       double most_final_velocity = kMostFinalVelocity);

/// @throws RecordError with that reason
void check_motion(const std::string& path, const GroundMotion& motion,
                  double most_final_velocity = kMostFinalVelocity);

/// The same motion with `factor` times its acceleration.
[[nodiscard]] GroundMotion scaled(GroundMotion motion, double factor);

} // namespace ground
