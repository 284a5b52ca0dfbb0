#pragma once
/// All that the page shows, as one JSON value. Stresses in MPa, forces in kN and displacements in mm
/// unless a name says otherwise; numbers that are not defined are null.

#include "app/report_replay.hpp"
#include "app/report_study.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace app {

constexpr std::size_t kMostCurves = 2'000; ///< walls with a curve and a row in the page

/// @param replay walls pushed again; may be empty
/// @param replay_note which walls were chosen, or why there are none
[[nodiscard]] nlohmann::ordered_json report_data(const ReportStudy& study, const Replay& replay,
                                                 const std::string& replay_note);

} // namespace app
