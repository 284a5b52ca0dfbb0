#pragma once
/// Limit drifts side by side: of files of studies, and of the folders that `fragility` writes.

#include "app/output/table/table.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Shares of the walls whose drifts are compared [-].
constexpr std::array<double, 5> kComparedShares = {0.05, 0.16, 0.5, 0.84, 0.95};

/// Drifts at which the walls of one stress have reached one limit state.
struct ComparedLimit {
    std::string name;  ///< of the file or folder
    std::string state; ///< "ntc SLC"
    Cell group;        ///< stress [MPa], or the name of a group
    std::string from;  ///< what its drifts are read off: "observed", "law", ...
    double walls = 0.0;
    std::array<Number, kComparedShares.size()> drifts{}; ///< [%]; without value: not known
};

/// Name of the file that makes a folder one of `fragility`.
constexpr std::string_view kFragilityFile = "fragility.json";

/// Reads FILE.h5, whose drifts are the shares observed (Kaplan and Meier), or a folder of
/// `fragility`, whose drifts are those of its table; nothing of anything else.
/// @throws ConfigError, StoreError
[[nodiscard]] std::vector<ComparedLimit> read_limits(const std::string& path);

/// By limit state and group, in the order in which they come first; medians are related to the
/// first of their limit state and group.
[[nodiscard]] Table compared_limit_table(const std::vector<ComparedLimit>& all);

/// SVG: the share of the walls over the drift, of the last limit state of the first.
[[nodiscard]] std::string compared_limit_chart(const std::vector<ComparedLimit>& all);

} // namespace app
