#pragma once
/// The steps of a history: they meet the samples of the record.

#include "dem/shaking/shake.hpp"

#include <vector>

namespace dem {

struct ShakingClock {
    double dt = 0.0;                ///< time step [s]
    long long substeps = 1;         ///< from a sample to the next one
    long long step = 0;             ///< now
    long long record = 0, last = 0; ///< ends of the record and of the free vibration

    [[nodiscard]] double time() const { return static_cast<double>(step) * dt; } ///< [s]
};

/// @param most longest time step [s]
[[nodiscard]] ShakingClock shaking_clock(const ShakePlan& plan, double most);

/// Acceleration of the ground at the beginning of the step [m/s2].
[[nodiscard]] double ground_now(const std::vector<double>& acceleration,
                                const ShakingClock& clock);

} // namespace dem
