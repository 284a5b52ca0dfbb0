#pragma once
/// Pictures of motions.

#include "ground/record.hpp"

#include <string>
#include <vector>

namespace app {

/// Acceleration [g] over time, its peak marked.
[[nodiscard]] std::string motion_svg(const ground::Record& record);

/// @param spectra [g] at spectrum_periods(), one for each record
[[nodiscard]] std::string spectrum_svg(const std::vector<ground::Record>& records,
                                       const std::vector<std::vector<double>>& spectra);

} // namespace app
