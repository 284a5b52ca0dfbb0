#pragma once
/// A push as a time series for ParaView: blocks in wall.pvd, joints in joints.pvd.

#include "dem/scene/snapshot.hpp"

#include <filesystem>
#include <string>
#include <vector>

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

/// Creates `folder` if needed and writes wall_0000.vtu ..., joints_0000.vtu ..., then wall.pvd
/// and joints.pvd, which name them. Time is the way of the load line in mm: its displacement in
/// a monotonic push. Of snapshots at the same time the last is kept. Files of an earlier series are
/// removed. Throws std::runtime_error if a file cannot be written.
void write_vtk_series(const std::filesystem::path& folder,
                      const std::vector<dem::Snapshot>& walls);

/// Removes what write_vtk_series has written there, and the folder if nothing else is in it.
void remove_vtk_series(const std::filesystem::path& folder);

} // namespace app
