#pragma once
/// How the shares of the failure modes depend on the thresholds of the rule that defines the
/// modes.

#include <functional>
#include <span>
#include <vector>

namespace fragility {

/// The mode, 0 .. modes - 1, of a wall with these figures (share of rotation, of sliding,
/// energies, ...) under these thresholds.
using ModeRule =
    std::function<int(std::span<const double> figures, std::span<const double> thresholds)>;

struct ThresholdShares {
    std::vector<double> thresholds;
    std::vector<double> counts; ///< walls of each mode
    std::vector<double> shares; ///< counts / walls
    double moved = 0.0; ///< share of walls whose mode is not that of the first thresholds
};

/// Shares of the modes for each set of thresholds. The others are compared with the first set.
/// @throws std::invalid_argument without walls or thresholds, or if the rule gives no such mode
[[nodiscard]] std::vector<ThresholdShares>
mode_shares(std::span<const std::vector<double>> walls,
            std::span<const std::vector<double>> thresholds, const ModeRule& rule, int modes);

/// All combinations of the values of each threshold, the last running fastest.
[[nodiscard]] std::vector<std::vector<double>>
threshold_grid(std::span<const std::vector<double>> values);

} // namespace fragility
