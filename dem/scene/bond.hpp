#pragma once
/// Where the joints of a wall in courses are.

#include "dem/scene/wall.hpp"

#include <vector>

namespace dem {

constexpr double kSmallestPiece = 1e-6; // [m]; a shorter piece comes from rounding of the sizes

constexpr double kShortestUnit =
    1e-3; // [m]; shorter ones are slivers, whose stiffness is an accident

/// Between two head joints of a course, or a lintel.
struct CoursePiece {
    double x0 = 0.0, x1 = 0.0; ///< [m]
    bool whole = false;        ///< a unit of full length, as far as the bond goes
    int material = 0;          ///< as Block::material
};

/// The units of a course from left to right, without openings. Headers and shorter pieces are
/// not whole.
/// @param course from 1 at the bottom
[[nodiscard]] std::vector<CoursePiece> bonded_course(const WallGeometry& wall, int course);

/// A random head joint may come so close to an opening or a lintel that a sliver is left
/// between them. It joins the unit on its other side: no mason would lay it. @param pieces of a
/// course from left to right
void join_slivers(std::vector<CoursePiece>& pieces);

/// Height of the top of a course above the floor [m]; 0 of course 0.
[[nodiscard]] double top_of_course(const WallGeometry& wall, int course);

/// The largest length_cov at which no unit and no overlap of two courses becomes shorter than
/// kShortestUnit [-], >= 0.
[[nodiscard]] double most_length_cov(const WallGeometry& wall);

} // namespace dem
