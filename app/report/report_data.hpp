#pragma once
/// All that the page shows, as JSON. Stresses in MPa, forces in kN and displacements in mm
/// unless a name says otherwise; numbers that are not defined are null.

#include "app/fragility/numbers/drift_fits.hpp"
#include "app/report/report_replay.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/// @param study read with Keep::everything
/// @param listed the walls that the page knows, and calls 0, 1, ...
[[nodiscard]] nlohmann::ordered_json
report_data(const StudyWalls& study, const WallList& listed, const FitProgress& seen = {});

/// The walls that the page can show: {"note", "films": [{"wall", "geometry", "frames", "step",
/// "data"}], "geometries"}, without geometry where there are none.
/// @param replay walls pushed again, all of them listed; may be empty
/// @param note which walls were chosen, or why there are none
[[nodiscard]] nlohmann::ordered_json films_json(const PreparedStudy& ready,
                                                const WallList& listed, const Replay& replay,
                                                const std::string& note);

} // namespace app
