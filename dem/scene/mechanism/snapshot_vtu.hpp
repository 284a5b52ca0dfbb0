#pragma once
/// A wall at one instant as files of VTK, which ParaView shows.

#include "dem/scene/geometry/snapshot.hpp"

#include <string>
#include <vector>

namespace dem {

/// The content of a .vtu file: an unstructured grid (VTK XML, numbers as bytes). SI units.
///   blocks: a polygon each; points: displacement; cells: course, unit, block (index from 0)
///   joints: a poly-line through the contacts of each face; points: displacement (mean of both
///   sides), opening, slip, sigma, tau,
///           damage, area; cells: kind (0 bed, 1 head, 2 unit crack, 3 beam, 4 base), id,
///           block_a, block_b (-1: ground), normal
/// Both carry the field data load_displacement [m] and force [N].
/// @throws std::invalid_argument if a value is not finite
[[nodiscard]] std::string blocks_vtu(const Snapshot& wall);
[[nodiscard]] std::string joints_vtu(const Snapshot& wall);

/// The content of a .pvd file, which makes a time series of such files.
/// @param times of the files, in any unit, increasing, finite
/// @param files as many names of .vtu files, relative to the folder of the .pvd file
[[nodiscard]] std::string pvd_text(const std::vector<double>& times,
                                   const std::vector<std::string>& files);

} // namespace dem
