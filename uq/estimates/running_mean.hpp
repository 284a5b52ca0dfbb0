#pragma once
/// Error of the mean after j samples (the paper, Fig. 10).

#include "uq/estimates/estimate.hpp"

#include <span>
#include <vector>

namespace uq {

/// After `samples` samples, `sound` of them answered. Samples before the first sound one have
/// no entry.
struct RunningMean {
    std::size_t samples, sound;
    double mean;
    double error; ///< mean - reference, over |scale| if one was given
    double band;  ///< |error| stays below it with the given confidence at this j, same unit
};

struct Prescribed {
    double mean, sd; ///< of the distribution sampled; sd >= 0
};

/// Against the prescribed mean, with the band of independent samples: factor sd / sqrt(j). A
/// stratified design should stay well inside. The band holds at each j, not for all at once.
/// @param relative divide by |prescribed mean|, as Fig. 10 does
/// @throws std::invalid_argument for no sound sample, or a mean of 0 with `relative`
[[nodiscard]] std::vector<RunningMean> running_mean(std::span<const double> y,
                                                    const Prescribed& prescribed,
                                                    bool relative = true,
                                                    double confidence = kConfidence);

/// Against the mean of all n, for responses whose mean is not known: the mean of j of them
/// differs from that of all by s sqrt(1 / j - 1 / n). The error ends at 0 whatever the mean of
/// all is worth; that is what estimate_mean tells.
[[nodiscard]] std::vector<RunningMean>
running_mean(std::span<const double> y, bool relative = true, double confidence = kConfidence);

} // namespace uq
