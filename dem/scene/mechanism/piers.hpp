#pragma once
/// Piers and spandrels of a wall with openings: where they are, what they carry and how far
/// they move, read off snapshots.
///
/// A cut parts the blocks of the wall into two sides, each block to the side of its middle. A
/// pier carries what the stresses of all faces between the two sides add up to within it. So
/// the forces of all piers at one level are in balance with all that acts above it, however the
/// joints run.

#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/geometry/snapshot.hpp"
#include "dem/scene/layout.hpp"

#include <span>
#include <vector>

namespace dem {

struct Pier {
    Region at; ///< between its neighbours, over the height along which both sides are free
    double cut = 0.0; ///< level at which its forces are read, the same for its storey [m]
    int storey = 1;   ///< from 1 at the bottom
};

struct Spandrel {
    Region at;        ///< above an opening, up to the next one or the top
    double cut = 0.0; ///< middle of the opening, at which its forces are read [m]
};

struct Piers {
    std::vector<Pier> piers; ///< storey by storey from the bottom, each from left to right
    std::vector<Spandrel> spandrels; ///< in the order of the openings
};

/// Openings that one level crosses are a storey: the level that crosses most of them first.
/// Without openings there is nothing.
/// @param wall extent of the masonry
[[nodiscard]] Piers piers_of(std::span<const Opening> openings, const Region& wall);

/// Forces in a cut.
struct CutForce {
    double normal = 0.0; ///< compression [N]
    /// [N]; of a pier the force to the right of its upper on its lower part, of a spandrel the
    /// force downwards of its right on its left part.
    double shear = 0.0;
    double moment = 0.0; ///< of the normal force about the middle of the pier or spandrel [N m]
};

struct PierState {
    CutForce force;
    /// Sideways movement of its upper end against its lower end [m], positive to the right.
    double displacement = 0.0;
};

struct SpandrelState {
    CutForce force;
    double drop = 0.0; ///< of its right end against its left end, downwards [m]
};

/// Forces and movements of the piers and spandrels of one layout.
class PierProbe {
  public:
    PierProbe(const Layout& layout, Piers piers);

    [[nodiscard]] const Piers& piers() const { return piers_; }
    [[nodiscard]] PierState pier(std::size_t i, const Snapshot& wall) const;
    [[nodiscard]] SpandrelState spandrel(std::size_t i, const Snapshot& wall) const;

    /// Shear between the blocks on the floor and all others [N].
    [[nodiscard]] double base_shear(const Snapshot& wall) const;

    /// The blocks of a pier alone with the joints at their lower and upper ends, for
    /// mechanism(): the height is that of the pier.
    [[nodiscard]] Snapshot alone(std::size_t i, const Snapshot& wall) const;

    /// Weight of the blocks above the cut of a pier's storey, without the beam [N].
    [[nodiscard]] double weight_above(std::size_t i, const Layout& layout, const Elastic& stone,
                                      double gravity) const;

  private:
    /// A place on an end of a pier.
    struct Place {
        int block = kGround;
        Point at;
    };
    struct PierParts {
        std::vector<char> above;  ///< by block: above the cut
        std::vector<char> within; ///< by block: of the pier
        std::vector<Place> bottom, top;
    };
    struct SpandrelParts {
        std::vector<char> right;             ///< by block: at the right of the cut
        std::vector<Place> first_end, other; ///< at its left and at its right
    };
    static double movement(const std::vector<Place>& places, const Snapshot& wall,
                           double Point::*along);

    Piers piers_;
    std::vector<PierParts> parts_;
    std::vector<SpandrelParts> spandrels_;
    std::vector<char> off_floor_; ///< by block
};

} // namespace dem
