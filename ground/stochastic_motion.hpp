#pragma once
/// Ground motions drawn at random: white noise under an envelope, behind the filter of a soil.
/// Anyone may have them, and as many as are needed.

#include "ground/ground_motion.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace ground {

/// Noise times the envelope of Jennings, Housner & Tsai 1968 ((t / rise)^2, then 1, then a
/// decay to 5 % at the end), behind the filter of Kanai 1957 and Tajimi 1960 (an oscillator of
/// the soil on the rock) and the high-pass of Clough & Penzien 1975, which keeps velocity and
/// displacement of the ground finite.
struct KanaiTajimi {
    double peak = 1.0;           ///< PGA to which the motion is scaled [m/s2], > 0
    double frequency = 2.5;      ///< of the soil [Hz]; 15.6 rad/s: Kanai 1957, firm ground
    double damping = 0.6;        ///< of the soil [-]; the same source
    double low_frequency = 0.25; ///< of the high-pass [Hz]; its damping is 0.6
    double duration = 20.0;      ///< of the noise [s]
    double rise = 2.0;           ///< of the envelope [s]
    double strong = 8.0;         ///< time of full strength after it [s]
    double step = 0.01;          ///< between samples [s]
    std::uint64_t seed = 1;
    std::uint64_t record = 1; ///< number of the motion among those of one seed
};

/// The same bits for the same numbers. The motion goes on behind the noise until the filters
/// have come to rest. Cost and memory are in proportion to the duration.
/// @throws std::invalid_argument
[[nodiscard]] GroundMotion kanai_tajimi(const KanaiTajimi& given);

/// True if the text begins with kanai_tajimi and a bracket.
[[nodiscard]] bool is_stochastic(std::string_view text);

/// The motions that a text describes, each named by the text that gives it alone:
///   kanai_tajimi(peak 0.3 g, frequency 2.5 Hz, damping 0.6, low 0.25 Hz, duration 20 s,
///                rise 2 s, strong 8 s, step 0.01 s, seed 1, record 1)
/// All but the peak may be left out. With `records 20` in place of `record` records 1 to 20.
/// @throws std::invalid_argument with what is wrong and what to write
[[nodiscard]] std::vector<GroundMotion> stochastic_motions(std::string_view text);

} // namespace ground
