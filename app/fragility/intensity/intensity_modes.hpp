#pragma once
/// Fragility on the intensity by failure mode.

#include "app/fragility/intensity/intensity_data.hpp"
#include "app/fragility/numbers/fragility_output.hpp"

#include <vector>

namespace app {

/// For each stress, state and mode: the share of the mode in the histories that reached the
/// state, and the curve of the histories of that mode alone.
[[nodiscard]] Table intensity_mode_table(const IntensityData& data);

/// Shares of the modes at each intensity, for each stress whose histories share intensities.
[[nodiscard]] std::vector<NamedPicture> intensity_mode_pictures(const IntensityData& data);

} // namespace app
