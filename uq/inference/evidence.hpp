#pragma once
/// The evidence of a model: the integral of prior times likelihood.

#include "uq/inference/adaptive_metropolis.hpp"

namespace uq {

struct Evidence {
    double log_value;
    double std_error; ///< of log_value
};

/// Bridge sampling (Meng and Wong 1996) between the draws and a normal density fitted to the
/// first half of each chain; the second halves are the bridge's. The error is that of
/// Fruhwirth-Schnatter (2004), with the effective size of the draws.
/// @param log_density of prior times likelihood, with all its constants: what was drawn from
/// @throws std::invalid_argument if the draws have no covariance
[[nodiscard]] Evidence bridge_evidence(const LogDensity& log_density,
                                       const std::vector<Chain>& chains, std::uint64_t seed);

} // namespace uq
