#pragma once
/// One wall of a time series for ParaView (series_folder.hpp).

#include "dem/scene/snapshot.hpp"

#include <string>

namespace app {

/// An unstructured grid (VTK XML, numbers as bytes). SI units.
///   blocks: a polygon each; points: displacement; cells: course, unit, block (index from 0)
///   joints: a poly-line through the contacts of each face; points: displacement (mean of both
///   sides), opening, slip, sigma, tau,
///           damage, area; cells: kind (0 bed, 1 head, 2 unit crack, 3 beam, 4 base), id,
///           block_a, block_b (-1: ground), normal
/// Both carry the field data load_displacement [m] and force [N]. Throws std::invalid_argument
/// if a value is not finite.
[[nodiscard]] std::string blocks_vtu(const dem::Snapshot& wall);
[[nodiscard]] std::string joints_vtu(const dem::Snapshot& wall);

} // namespace app
