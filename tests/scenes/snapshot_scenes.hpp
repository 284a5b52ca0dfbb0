#pragma once
/// Made-up wall states with known openings, slips and cracks, for pictures and files. Nothing
/// is solved.

#include "dem/scene/geometry/snapshot.hpp"

namespace scenes {

/// Sizes of the paper's wall: 1 m x 1 m, 10 courses, running bond, units of two 100 mm blocks,
/// beam of 100 mm on top.
struct SnapshotWall {
    int courses = 10;
    int half_units = 10;        ///< per course, even
    double half_length = 0.1;   ///< [m]
    double course_height = 0.1; ///< [m]
    double thickness = 0.2;     ///< [m]
    int points = 4;             ///< contact points per face, >= 2
    double vertical_load = 1e5; ///< [N], for the stresses
};

/// The wall at rest: no displacement, no damage, uniform compression. Courses x half_units
/// blocks and the beam.
[[nodiscard]] dem::Snapshot wall_at_rest(const SnapshotWall& wall = {});

/// Everything above a 45 degree staircase from the toe turns about the toe (bottom right) until
/// the load line has moved by `displacement` [m]. No unit cracks.
[[nodiscard]] dem::Snapshot stair_step_rocking(double displacement,
                                               const SnapshotWall& wall = {});

/// A crack from the toe towards the top middle, through units and along joints; the part right
/// of it and above its end slides to the right and turns a little.
/// @param displacement of the load line [m]
/// @param share of the height that the crack reaches, in [0, 1]; units above it on the diagonal
/// are half damaged
[[nodiscard]] dem::Snapshot diagonal_crack(double displacement, double share,
                                           const SnapshotWall& wall = {});

} // namespace scenes
