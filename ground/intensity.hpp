#pragma once
/// Measures of the intensity of a motion. Integrals are sums by the trapezoidal rule over the
/// samples, as the networks and most programs take them; oscillators are exact for
/// accelerations that are linear between samples.

#include "ground/ground_motion.hpp"

#include <string>
#include <string_view>

namespace ground {

/// pi / (2 g) times the integral of a^2 [m/s] (Arias 1970).
[[nodiscard]] double arias_intensity(const GroundMotion& motion);

/// Integral of |a| [m/s].
[[nodiscard]] double cumulative_absolute_velocity(const GroundMotion& motion);

/// Time from a share of the Arias intensity to another [s], such as 0.05 and 0.95.
[[nodiscard]] double significant_duration(const GroundMotion& motion, double from, double to);

/// Pseudo-acceleration omega^2 max |u| [m/s2] of an oscillator, largest at the samples of a
/// step of at most a fortieth of the period.
/// @param period [s], > 0
/// @param damping share of critical, in [0, 1)
[[nodiscard]] double spectral_acceleration(const GroundMotion& motion, double period,
                                           double damping = 0.05);

/// Geometric mean of the pseudo-accelerations at ten periods, evenly from 0.2 to 1.5 times
/// `period` [m/s2] (Eads et al. 2015; the range of oq-vmtk).
[[nodiscard]] double average_spectral_acceleration(const GroundMotion& motion, double period);

/// FIV3 [m/s] (Davalos & Miranda 2019, doi 10.1002/eqe.3205): the acceleration behind a
/// low-pass of second order at 0.85 / period, its integral over windows of 0.7 period; the sum
/// of its three largest maxima or of its three least minima, whichever is larger in absolute
/// value. The filter is causal.
[[nodiscard]] double filtered_incremental_velocity(const GroundMotion& motion, double period);

/// A rigid block of the slenderness tan(alpha) = half_width / half_height.
struct RockingBlock {
    double half_width = 0.0;  ///< [m], > 0
    double half_height = 0.0; ///< [m], > 0

    friend bool operator==(const RockingBlock&, const RockingBlock&) = default;
};

/// PGA / (g tan alpha): the block starts to rock above 1 [-].
[[nodiscard]] double rocking_pga(const GroundMotion& motion, const RockingBlock& block);

/// PGV p / (g tan alpha), p^2 = 3 g / (4 R) [-] (Giouvanidis & Dimitrakopoulos 2018).
[[nodiscard]] double rocking_pgv(const GroundMotion& motion, const RockingBlock& block);

enum class MeasureKind {
    pga,
    pgv,
    pgd,
    sa,
    avg_sa,
    fiv3,
    cav,
    arias,
    duration,
    rocking_pga,
    rocking_pgv
};

/// A measure by name: pga, pgv, pgd, sa(0.3 s), avg_sa(0.3 s), fiv3(0.3 s), cav, arias, d5_95,
/// rocking_pga(0.5 m, 0.6 m) and rocking_pgv(0.5 m, 0.6 m) of a block by its half width and
/// half height.
struct Measure {
    MeasureKind kind = MeasureKind::pga;
    double period = 0.0;  ///< [s], of those that have one
    RockingBlock block{}; ///< of those that have one

    friend bool operator==(const Measure&, const Measure&) = default;
};

/// @throws std::invalid_argument with what is wrong and what to write
[[nodiscard]] Measure parse_measure(std::string_view text);

/// "sa(0.3 s)"
[[nodiscard]] std::string measure_text(const Measure& measure);

/// Unit in which people read it: "g", "m/s", "m", "s", "-", and its value in SI.
[[nodiscard]] std::string_view measure_unit(const Measure& measure);
[[nodiscard]] double measure_unit_value(const Measure& measure);

/// In SI.
[[nodiscard]] double intensity(const GroundMotion& motion, const Measure& measure);

} // namespace ground
