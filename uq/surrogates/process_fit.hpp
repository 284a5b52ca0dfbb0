#pragma once
/// Gaussian process whose parameters are those of the greatest likelihood.

#include "uq/surrogates/gaussian_process.hpp"

#include <optional>

namespace uq {

struct ProcessFitOptions {
    ProcessKernel kernel = ProcessKernel::matern_52;
    ProcessTrend trend = ProcessTrend::constant;
    std::optional<double>
        noise{}; ///< variance of the noise of all points, >= 0; nothing: estimated
    /// Estimated noise may grow or fall with each input, by an exponential law (Boukouvalas,
    /// Cornford, Stehlik 2014): noise_slopes are estimated too.
    bool noise_varies = false;
    int evaluations = 60; ///< of the likelihood from each start that is followed, at most
    /// The only start; with slopes of the noise if they are estimated. Nothing: fixed ones.
    std::optional<ProcessParameters> from{};
};

/// The likelihood is evaluated at eight fixed starts, and the best two of them are followed
/// (NLopt, SLSQP with the exact gradient). Lengths stay within 0.05 and 100 standard deviations
/// of their input, estimated noise within 1e-8 and 2 variances of the response, its slopes
/// within 2 for a standard deviation of an input. The answer depends on nothing but the data
/// and the options.
/// @throws std::invalid_argument as condition, or if the response does not vary
[[nodiscard]] GaussianProcess fit_process(const ProcessData& data,
                                          const ProcessFitOptions& options = {});

/// Predictions of each point by a process that has not seen it, nor has its choice of
/// parameters: the points are parted into `folds` (row modulo folds), and the parameters, with
/// noise, are fitted anew without each part; with more than 100 points they start from those of
/// `fit`. Where the rest cannot be fitted, as where they are equal, the parameters of `fit`
/// stay. leave_one_out keeps the parameters everywhere, and promises too much where points are
/// few for the number of lengths.
/// @param fit of estimated noise, without noise of points alone  @param folds 2 or more
[[nodiscard]] ProcessLeaveOneOut held_out(const GaussianProcess& fit, int folds = 10);

/// Whether noise that varies is better beyond doubt: points left out have a larger log score,
/// and the likelihood gains more than slopes bring one fit in a hundred where the noise is the
/// same everywhere (Wilks 1938). The score alone would choose slopes in one of seven such fits.
[[nodiscard]] bool noise_clearly_varies(const GaussianProcess& varies,
                                        const GaussianProcess& same);

} // namespace uq
