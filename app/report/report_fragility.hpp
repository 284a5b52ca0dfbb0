#pragma once
/// Fragility curves and mode probabilities for the page.

#include "app/output/table.hpp"
#include "app/report/report_study.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace app {

/// P(ultimate drift <= drift) of each stress, from the walls of each mode (lognormal, censored maximum
/// likelihood) and their shares; Kaplan-Meier steps beside it. Drifts in percent of the height of
/// the load:
/// [{"level", "drift": [...], "least", "most", "lower", "upper", "steps": [[drift, probability], ...],
///   "known_to", "fits": text of each mode, "fitted": any of them}]
[[nodiscard]] nlohmann::ordered_json fragility_json(const ReportStudy& study);

/// Median and dispersion of the ultimate drift of each stress, all modes pooled.
[[nodiscard]] Table fragility_table(const ReportStudy& study);

/// Share of rocking walls of each stress with its interval, and a logistic regression on the stress:
/// {"levels": [{"stress" [MPa], "value", "lower", "upper", "walls"}],
///  "model": {"stress", "value", "lower", "upper"}, "note": text}; no "model" below two stresses, or if it
/// does not fit the shares, which the note says.
[[nodiscard]] nlohmann::ordered_json modes_json(const ReportStudy& study);

} // namespace app
