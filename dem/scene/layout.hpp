#pragma once
/// The scene that the solver takes: blocks with their outlines, the faces where they touch, the
/// IDs of joints and cracks, supports, and what the vertical load acts on. lay_out() makes it
/// of a wall in courses, drawn_layout() of outlines from anywhere.

#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace dem {

constexpr int kGround = -1; ///< block index of the ground in Face

/// Support of a block.
enum class Motion {
    free,
    clamped_bottom,            ///< the bottom face is fixed
    clamped_bottom_held_right, ///< in addition, the right side has no horizontal displacement
    held_right_corner,         ///< the lower right corner has no horizontal displacement
    clamped_bottom_held_left,  ///< as clamped_bottom_held_right, of the left side
    held_left_corner,          ///< as held_right_corner, of the lower left corner
    driven ///< the loading beam: the horizontal displacement of its load line is prescribed
};

/// Whether the bottom face of a block is fixed.
[[nodiscard]] constexpr bool is_clamped(Motion m)
{
    return m == Motion::clamped_bottom || m == Motion::clamped_bottom_held_right ||
           m == Motion::clamped_bottom_held_left;
}

/// Whether one lower corner of a block is a hinge.
[[nodiscard]] constexpr bool is_hinged(Motion m)
{
    return m == Motion::held_right_corner || m == Motion::held_left_corner;
}

/// Whether the left side or corner of a block is held.
[[nodiscard]] constexpr bool is_held_left(Motion m)
{
    return m == Motion::clamped_bottom_held_left || m == Motion::held_left_corner;
}

/// A block between joints and potential cracks. A whole unit of a wall in courses consists of
/// two blocks with a potential crack between them.
struct Block {
    double x0 = 0.0, x1 = 0.0; ///< extent [m]; the block's own frame begins at (x0, z0)
    double z0 = 0.0, z1 = 0.0; ///< extent [m]
    int course = 0; ///< from 1 at the bottom; 0 is the loading beam. Without courses: by height
    int unit = 0;   ///< number of the unit from 1; 0 is the loading beam
    std::vector<Point> outline; ///< counter-clockwise [m]; empty: a rectangle
    int material = 0;           ///< 0: the stone of the wall; k: Layout::stones[k - 1]
    int layer = 0;              ///< DrawnUnit::layer
    Motion motion = Motion::free;
    bool between_cracks =
        false; ///< its unit shares its stiffness with cracks (Layout::crack_rigidity)
};

/// A straight piece of joint between block a (below, or left) and block b (above, or right).
struct Face {
    FaceKind kind = FaceKind::bed_joint;
    int id = 0; ///< joint ID or crack ID, from 1; 0 for the joints at the base and at the beam
    int a = kGround; ///< index in Layout::blocks
    int b = 0;       ///< index in Layout::blocks
    Point from, to;  ///< end points [m], left to right, or bottom to top where it is steep
    Point normal;    ///< unit vector from a to b; the tangent is (nz, -nx)
};

/// Joint IDs of a wall in courses run course by course from the bottom: first the head joints
/// of a course from left to right, then the pieces of bed joint above it from left to right.
/// Crack IDs run in the same order. Without courses joint IDs run from the bottom to the top
/// and from left to right, by the middle of the face. The faces at the base and at the beam
/// have no ID.
struct Layout {
    std::vector<Block>
        blocks; ///< course by course from the bottom, each from left to right; a beam is the last
    std::vector<Face> faces;
    int n_joints = 0;
    int n_cracks = 0;
    int beam = 0;               ///< index of the loading beam; without one the number of blocks
    double thickness = 0.0;     ///< out of plane [m]
    double length = 0.0;        ///< on which the vertical stress acts [m]
    double height = 0.0;        ///< of the masonry, without the beam [m]
    int courses = 0;            ///< without courses: height over the mean height of a block
    double course_height = 0.0; ///< [m]
    double half_unit = 0.0; ///< length of face that Discretisation::contact_points is for [m]
    bool coursed = true;    ///< blocks are rectangles in level courses
    bool mortar =
        false; ///< joints between units follow the law of cracks, with their own materials
    bool crushing = false;             ///< joints and cracks may crush, as their materials say
    bool wear = false;                 ///< dry joints may wear, as their materials say
    Closure closure = Closure::linear; ///< of dry joints, as their materials say
    /// Cracks follow the law of mixed modes, in place of that of the paper, as their materials
    /// say.
    bool mixed_mode = false;
    std::vector<Elastic> stones; ///< of blocks that are not of the wall's stone
    int lintels = 0;      ///< Block::material of units that have no potential cracks; 0: none
    bool divided = false; ///< joints may fall into several faces, along pieces of units
    /// By crack ID: k_n over Young's modulus of the stone [1/m]; 0: as the paper, by the
    /// joints' k_n. Or empty: all 0.
    std::vector<double> crack_stiffness;
    /// r of units that share their stiffness with cracks: the cracks have r E / spacing, and
    /// the pieces r / (r - 1) times the modulus and Poisson's ratio of the stone, so that
    /// together they deform as the unit does.
    double crack_rigidity = 50.0;
};

/// Area of a block [m2] and the middle of this area.
[[nodiscard]] double area_of(const Block& block);
[[nodiscard]] Point centre_of(const Block& block);

/// The stone of a block.
/// @param wall stone of the wall, of which blocks are that have none of their own
[[nodiscard]] const Elastic& stone_of(const Layout& layout, int block, const Elastic& wall,
                                      const Elastic& beam);

/// Layout::crack_stiffness of a crack [1/m]. @param crack its ID - 1
[[nodiscard]] double own_stiffness(const Layout& layout, std::size_t crack);

/// The stone of the pieces of a unit that share its stiffness with cracks, from that of the
/// unit.
[[nodiscard]] Elastic between_cracks(const Elastic& unit, double rigidity);

/// A block of this outline; a rectangle keeps none.
[[nodiscard]] Block block_of(std::vector<Point> outline);

/// Two sides closer than this touch [m]. Outlines must be welded as closely.
constexpr double kTouching = 1e-6;
/// Pieces of joint below this length carry nothing and are left out [m].
constexpr double kShortestFace = 1e-4;

/// @param beam_height [m]; 0: no beam
/// @throws std::invalid_argument if a size is outside its range
[[nodiscard]] Layout lay_out(const WallGeometry& wall, double beam_height);

} // namespace dem
