#pragma once
/// Drifts that tests of stone masonry walls have shown, to set beside the walls of a study.

#include "app/output/table/table.hpp"

namespace app {

/// Ultimate drifts of the EPFL Stone Masonry Database by typology and mode of failure.
[[nodiscard]] Table measured_drifts();

} // namespace app
