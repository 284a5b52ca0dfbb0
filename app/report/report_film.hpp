#pragma once
/// The motion of a wall, small enough that a page carries hundreds of them.

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/layout.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace app {

/// Geometry that all walls of a study have in common: blocks and faces, lengths in metres.
/// Blocks that are not rectangles have their corners as well, faces that are neither level nor
/// upright their normal.
[[nodiscard]] nlohmann::ordered_json wall_geometry(const dem::Layout& layout);

constexpr double kFilmStep = 1e-5; ///< displacements are rounded to this [m]

/// Displacement of a block as an affine map of its undeformed box, by least squares over the
/// four corners of a rectangle, or over all points of another outline: at (xi, zeta) in [-1,
/// 1]^2 it is a + b xi + c zeta.
struct BlockMotion {
    dem::Point a, b, c; ///< [m]
};

/// How the motion of a block follows from the displacements of its outline, in any frame.
class MotionFit {
  public:
    /// @throws std::invalid_argument for an outline without points, or one that is no rectangle
    /// and has no area
    explicit MotionFit(const std::vector<dem::Point>& outline);
    /// @param displacement of each point of the outline [m]
    [[nodiscard]] BlockMotion motion(const std::vector<dem::Point>& displacement) const;

    /// Places in an outline of the points nearest to the corners of its box.
    struct Corners {
        std::size_t lower_left, lower_right, upper_left, upper_right;
    };
    /// Weights of the displacements of the outline in a, b and c of a BlockMotion.
    struct Weights {
        std::vector<double> a, b, c;
    };

  private:
    Corners at_;
    Weights weights_; ///< empty for a rectangle
};

/// Frames of one wall.
struct Film {
    int frames = 0;
    double step = kFilmStep; ///< of displacements [m]; larger where the wall comes down
    /// Base64 of a zlib stream of differences() of: displacement of the load line, a series
    /// over the frames (order 2); of each of ax az bx bz cx cz of each block, such a series
    /// (order 2); mean damage of each unit crack in steps of 1/255, such a series (order 1). If
    /// `crushing`, two more of each face, like those of damage: the largest share of strength
    /// that contacts of its first and of its second half have lost, at least one step where one
    /// has begun to crush.
    std::string data;
    bool crushing = false; ///< whether a contact of the wall crushes
};
/// @param frames at least one, all of the same wall
[[nodiscard]] Film film_of(std::span<const dem::Snapshot> frames);

} // namespace app
