#pragma once
/// Share of each input in a linear, or monotonic, model of the response with all inputs.
///
/// Regression on standardised values; with ranks in place of values for monotonic responses
/// (Iman and Conover 1979; Saltelli, Chan, Scott 2000, chapter 6). r2 says what that model
/// explains at all: with a low one its coefficients say little.

#include "uq/estimates/estimate.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace uq {

enum class RegressionScale {
    values, ///< standardised regression (SRC) and partial correlation (PCC) coefficients
    ranks   ///< SRRC and PRCC
};

struct RegressionCoefficient {
    /// Change of the response per change of the input, both in standard deviations [-].
    Estimate standardised;
    /// Correlation left when the other inputs' linear part is taken off both [-], in [-1, 1].
    Estimate partial;
    /// False: the input is constant, or a combination of others to 1e-9 (rank-revealing QR).
    /// Its coefficient cannot be told from theirs: the value is that of the solution of least
    /// norm, the standard error infinite, the partial one 0 in [-1, 1].
    bool identifiable;
};

struct Regression {
    std::vector<RegressionCoefficient> inputs;
    double r2;         ///< share of the variance explained [-]
    Eigen::Index rank; ///< independent inputs
    std::size_t n, failed;
};

struct RegressionOptions {
    RegressionScale scale = RegressionScale::values;
    double confidence = kConfidence;
    /// Resamples for percentile intervals and standard errors; 0: asymptotic ones. Those of the
    /// standardised coefficient allow for unequal scatter and for the spread of the sampled
    /// deviations; those of the partial one are Fisher's, for normal values, with the variance
    /// (1 + r^2 / 2) / (n - d - 2) of z for ranks, as of Spearman's.
    std::size_t bootstrap = 0;
    std::uint64_t seed = 1; ///< of the resamples
};

/// Nothing is returned if the response does not vary.
/// @param x n x d, NaN in a row of x or y: failed, left out and counted
/// @throws std::invalid_argument if the lengths differ, a value is infinite, or fewer than d +
/// 4 samples are sound
[[nodiscard]] std::optional<Regression> regress(const Eigen::MatrixXd& x,
                                                const Eigen::VectorXd& y,
                                                const RegressionOptions& options = {});

} // namespace uq
