#pragma once
/// A normal variable d of which tests say that it is larger, each with an error of its own:
///
///   d ~ N(mean, variance),   d + e_k > at_k,   e_k ~ N(0, deviation_k^2)

#include "uq/designs/stream.hpp"

#include <span>

namespace uq {

struct NoisyBound {
    double at, deviation; ///< deviation > 0
};

/// ln of the probability that all bounds hold: one of them in closed form, several by Gauss
/// rules on panels about the greatest of the integrand and about each bound, so that neither
/// bounds far beyond d nor errors far below its scatter are missed.
/// @param variance of d, >= 0
[[nodiscard]] double log_beyond(std::span<const NoisyBound> bounds, double mean,
                                double variance);

/// d where all bounds hold.
/// @param variance of d, >= 0
[[nodiscard]] double draw_beyond(std::span<const NoisyBound> bounds, double mean,
                                 double variance, Stream& random);

} // namespace uq
