#pragma once
/// The limit drifts of a group of walls, chosen once: tables, pages, curves, files for other
/// programs read them here.

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/output/table/table.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace app {

/// Judges all laws and chooses the drifts of all limit states, once; without it each table does
/// so for itself.
void choose_limits(DriftData& data, const FitProgress& seen = {});

/// The drifts, in intervals that hold wherever the drifts of walls that miss the accuracy lie
/// within their error.
[[nodiscard]] LimitDrifts limit_drifts(const DriftData& data, std::size_t group,
                                       std::size_t state);

/// Whether walls give drifts of a limit state. Else no law can be fitted (fewer than three
/// walls, or fewer than two that reached it), and at most a bound of the median is known.
[[nodiscard]] bool identified(const LimitDrifts& limits);

/// Why they do not: "Not identifiable: no wall reached it."
[[nodiscard]] std::string not_identified_text(const LimitDrifts& limits,
                                              const DriftGroup& group);

/// "2.45 [2.03, no limit]"; "> 2.72" where only a lower bound is known.
[[nodiscard]] Number quantile_cell(const fragility::LimitQuantile& quantile, int decimals);

/// "law", "mixture", "observed"; "law, observed" where the upper shares are those observed;
/// empty without numbers.
[[nodiscard]] std::string source_text(const fragility::LimitQuantiles& quantiles);

/// The reason why drifts are not those of one law; empty where they are.
[[nodiscard]] std::string source_note(const LimitDrifts& limits);

/// Whether one law of all walls gives all of them, so that its curve is theirs.
[[nodiscard]] bool of_one_law(const fragility::LimitQuantiles& quantiles);

/// Half of the distance of ln 16 % and ln 84 % drift, in standard normal deviates; of a law,
/// its own. Nothing where one of both is not known.
[[nodiscard]] std::optional<double> dispersion_of(const LimitDrifts& limits);

} // namespace app
