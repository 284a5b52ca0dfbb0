#pragma once
/// Quantiles of a sample.

#include "uq/estimates/estimate.hpp"

#include <span>

namespace uq {

/// The quantile between two values of the sample, median-unbiased (Hyndman and Fan 1996,
/// definition 8). The interval lies between two values of the sample, from the binomial count
/// below the quantile: it supposes no distribution, and its coverage is at least the
/// confidence. A limit is infinite if no value of the sample is far enough out. Failed samples
/// count as lower than all others for the lower limit and as higher for the upper one. Standard
/// error after Maritz and Jarrett (1978).
/// @param p in (0, 1)
/// @throws std::invalid_argument for fewer than 2 sound values, p or confidence out of range
[[nodiscard]] Estimate estimate_quantile(std::span<const double> y, double p,
                                         double confidence = kConfidence);

} // namespace uq
