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
};

/// The likelihood is evaluated at eight fixed starts, and the best two of them are followed
/// (NLopt, SLSQP with the exact gradient). Lengths stay within 0.05 and 100 standard deviations
/// of their input, estimated noise within 1e-8 and 2 variances of the response, its slopes
/// within 2 for a standard deviation of an input. The answer depends on nothing but the data
/// and the options.
/// @throws std::invalid_argument as condition, or if the response does not vary
[[nodiscard]] GaussianProcess fit_process(const ProcessData& data,
                                          const ProcessFitOptions& options = {});

/// Whether noise that varies is better beyond doubt: points left out have a larger log score,
/// and the likelihood gains more than slopes bring one fit in a hundred where the noise is the
/// same everywhere (Wilks 1938). The score alone would choose slopes in one of seven such fits.
[[nodiscard]] bool noise_clearly_varies(const GaussianProcess& varies,
                                        const GaussianProcess& same);

} // namespace uq
