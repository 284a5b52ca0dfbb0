#pragma once
/// Error of the mean after j samples (the paper, Fig. 10).

#include "uq/estimates/estimate.hpp"

#include <span>
#include <vector>

namespace uq {

/// The mean after `samples` samples, of which `sound` answered. There is no entry before the
/// first sound sample.
struct RunningMean {
    std::size_t samples, sound;
    double mean;
    double error; ///< mean - reference, over |scale| if one was given
    double band;  ///< |error| stays below it with the given confidence at this j, same unit
};

struct Prescribed {
    double mean, sd; ///< of the distribution sampled; sd >= 0
};

/// Compares the running mean with the prescribed one. The band is that of independent samples,
/// factor sd / sqrt(j); a stratified design should stay well inside it. The band holds at each
/// j, not for all at once.
/// @param relative divide by |prescribed mean|, as Fig. 10 does
/// @throws std::invalid_argument for no sound sample, or a mean of 0 with `relative`
[[nodiscard]] std::vector<RunningMean> running_mean(std::span<const double> y,
                                                    const Prescribed& prescribed,
                                                    bool relative = true,
                                                    double confidence = kConfidence);

/// Compares the running mean with the mean of all n, for responses whose mean is not known: the
/// mean of j of them differs from that of all by about s sqrt(1 / j - 1 / n). The error ends at
/// 0 however uncertain the mean of all is; estimate_mean gives that uncertainty.
[[nodiscard]] std::vector<RunningMean>
running_mean(std::span<const double> y, bool relative = true, double confidence = kConfidence);

} // namespace uq
