#pragma once

#include <string>
#include <vector>

namespace ground {

/// One component of the motion of the ground. The acceleration is linear between samples; the
/// first sample is at time 0.
struct GroundMotion {
    std::string name;                 ///< of the record or the pulse
    double step;                      ///< time between samples [s], > 0
    std::vector<double> acceleration; ///< of the ground [m/s2], finite
};

} // namespace ground
