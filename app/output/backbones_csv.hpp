#pragma once
/// The backbones of a push to and fro as a table.

#include "fragility/curve/cyclic_curve.hpp"

#include <string>

namespace app {

/// "side,displacement_mm,force_kN" and the points of both backbones, "right" and "left",
/// displacements and forces positive on either side.
/// @param path displacements in [m], forces in [N]
[[nodiscard]] std::string backbones_csv(const fragility::Path& path);

} // namespace app
