#pragma once
/// Quantiles of a sample, and what sample size or margin a quantile takes.

#include "uq/estimates/estimate.hpp"

#include <span>

namespace uq {

enum class QuantileKind {
    /// Between two values of the sample, median-unbiased (Hyndman and Fan 1996, definition 8).
    interpolated,
    /// A weighted mean of all values (Harrell and Davis 1982): smaller error, smooth in p.
    smoothed
};

/// Interval between two values of the sample, from the binomial count below the quantile: no
/// distribution is supposed, coverage at least the confidence. Where no value of the sample is
/// far enough out, the limit is infinite. Failed samples count as lower than all for the lower
/// limit and higher than all for the upper. Standard error after Maritz and Jarrett (1978), of
/// the smoothed one by the jackknife.
/// @param p in (0, 1)
/// @throws std::invalid_argument for fewer than 2 sound values, p or confidence out of range
[[nodiscard]] Estimate estimate_quantile(std::span<const double> y, double p,
                                         double confidence = kConfidence,
                                         QuantileKind kind = QuantileKind::interpolated);

/// Smallest n for which the `order`-th largest of n values is above the p-quantile with the
/// given confidence (Wilks 1941): 59, 93, 124 for 0.95, 0.95 and order 1, 2, 3. Two-sided, for
/// the share p between the order-th smallest and the order-th largest: as one-sided with 2
/// order.
/// @throws std::invalid_argument for p or confidence outside (0, 1), or order < 1
[[nodiscard]] int wilks_sample_size(double p, double confidence, int order = 1);

/// k such that mean + k s of n normal values is above the p-quantile with the given confidence
/// (one-sided tolerance factor, non-central t). @param n >= 2
[[nodiscard]] double tolerance_factor(int n, double p, double confidence);

/// k such that one more normal value is below mean + k s with probability p:
/// t(p, n - 1) sqrt(1 + 1 / n) (EN 1990, Table D1, V_X unknown). @param n >= 2
[[nodiscard]] double prediction_factor(int n, double p);

} // namespace uq
