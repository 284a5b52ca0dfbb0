#pragma once
/// The laws of limit drifts and whether the walls bear them out. One rule for every output:
/// where a test of goodness of fit rejects a law at fragility::kRejected, the shares observed
/// (Kaplan-Meier) are used instead.

#include "app/fragility/numbers/fragility_data.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace app {

/// Fits and tests the law of one group.
/// @param group its number, which keys the random samples: equal drifts have equal p-values
[[nodiscard]] JudgedFit judged(const DriftOptions& options, fragility::Law law,
                               std::span<const fragility::Observation> limits,
                               std::size_t group, const std::function<void(double)>& seen = {});

/// Told how far the fits are [0 to 1], and whose fit is at hand: "0.50 MPa, paper ultimate".
using FitProgress = std::function<void(double done, const std::string& fit)>;

/// Fits and tests all laws once; without it each table does so for itself.
void judge(DriftData& data, const FitProgress& seen = {});

/// Fit of one limit state: of all walls of a group, or of one mode.
[[nodiscard]] JudgedFit judged_fit(const DriftData& data, std::size_t group, std::size_t state,
                                   int mode = -1);

/// The lognormal law of all walls of a group, whatever law was chosen.
[[nodiscard]] JudgedFit judged_lognormal(const DriftData& data, std::size_t group,
                                         std::size_t state);

[[nodiscard]] bool rejected(const JudgedFit& f);

/// There is a fit and no test rejects it.
[[nodiscard]] bool describes(const JudgedFit& f);

/// "The fitted curve does not describe the walls (p = 0.001); ..."
[[nodiscard]] std::string rejected_text(const JudgedFit& f);

} // namespace app
