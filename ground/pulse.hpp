#pragma once
/// Pulses with a formula: ground motions that anyone may have.

#include "ground/ground_motion.hpp"

#include <string>
#include <string_view>

namespace ground {

/// True if the text begins with the name of a pulse and a bracket, so that it names no file.
[[nodiscard]] bool is_pulse(std::string_view text);

/// The names of all pulses: "half_sine, sine, ...".
[[nodiscard]] std::string pulse_names();

/// The motion that a text describes:
///   half_sine(peak 0.5 g, duration 0.3 s)        a = A sin(pi t / D)
///   sine(peak 0.5 g, period 0.6 s, cycles 1)     a = A sin(2 pi t / T)
///   cosine(peak 0.5 g, period 0.6 s, cycles 1)   a = A cos(2 pi t / T)
///   ricker(peak 0.5 g, period 0.6 s)             a = A (1 - 2 s^2) exp(-s^2)
///                                                with s = pi (t - 1.5 T) / T
///   mavroeidis_papageorgiou(velocity 0.5 m/s, period 1 s, cycles 2, phase 0 deg)
///       v = A / 2 (1 + cos(2 pi t / (c T))) cos(2 pi t / T + phase), |t| <= c T / 2
///       (Mavroeidis & Papageorgiou 2003, Bull. Seism. Soc. Am. 93(3))
/// Cycles and phase may be left out (1, 2 and 0 deg). Each takes `step`, the time between
/// samples (default: 400 in a period or duration). Its name is the text.
/// @throws std::invalid_argument with what is wrong and what to write
[[nodiscard]] GroundMotion pulse(std::string_view text);

} // namespace ground
