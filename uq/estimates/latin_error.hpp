#pragma once
/// Standard errors of means under a Latin hypercube. A hypercube takes the part of a response
/// that is additive in its inputs out of the error of the mean; what is left is the residual of
/// an additive fit (Stein 1987, Technometrics 29, 143-151; Owen 1992, J. R. Stat. Soc. B 54,
/// 541-551). Errors of independent samples are too large there, by a factor of four where a
/// response is nearly additive.

#include <Eigen/Dense>

#include <span>
#include <vector>

namespace uq {

/// Degree of the additive functions for which the samples suffice: 2 from 4 (2 inputs + 1) on,
/// 1 from 4 (inputs + 1) on, else 0, where the error is that of independent samples.
[[nodiscard]] int latin_degree(Eigen::Index samples, Eigen::Index inputs);

/// Standard error of the mean of y: s / sqrt(n), with s the standard deviation of the residual
/// of an additive regression on the ranks of the inputs, each residual over the root of 1 - its
/// leverage. Its functions are Hermite polynomials of normal scores or cosines of ranks,
/// whichever miss samples left out by less, of latin_degree. Stated over true error is 0.85 to
/// 1.3 for responses that are smooth or jump across several inputs; it is an upper bound, up
/// to 9 times too large, where the response jumps, bends or swings with one input alone.
/// @param y  finite, at least 2  @param inputs  one row for each sample, one column for each
/// independent input; values only rank
/// @throws std::invalid_argument for other sizes, or a value that is not finite
[[nodiscard]] double latin_mean_error(std::span<const double> y, const Eigen::MatrixXd& inputs);

/// The same of the mean of y over those samples that are members, as a ratio of two means: by
/// the residual of member (y - mean) / share (Cochran 1977, Sampling Techniques, 6.3).
/// @param member one for each sample, 2 of them or more; y of others is not looked at
[[nodiscard]] double latin_subset_error(std::span<const double> y,
                                        const std::vector<bool>& member,
                                        const Eigen::MatrixXd& inputs);

} // namespace uq
