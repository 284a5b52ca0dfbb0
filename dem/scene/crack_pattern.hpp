#pragma once
/// Where units may crack: the lines and cells that divide a unit into pieces.

#include "dem/scene/geometry/polygon.hpp"

#include <vector>

namespace dem {

struct CrackPattern {
    enum class Kind {
        none,
        mid,  ///< one vertical line at mid-length, of whole units only (paper, Fig. 2)
        grid, ///< `columns` x `rows` pieces of a whole unit; shorter units have as wide ones
        diagonals, ///< both diagonals of the unit's extent
        voronoi    ///< cells of about `size` by `size` around random sites
    };
    Kind kind = Kind::mid;
    int columns = 2, rows = 1; ///< of a grid, >= 1
    double size = 0.0;         ///< of voronoi cells [m], > 0
    friend bool operator==(const CrackPattern&, const CrackPattern&) = default;
};

struct UnitCracks {
    CrackPattern pattern{};
    std::vector<Region> where{}; ///< of units whose middle lies in one of them; none: of all
    CrackPattern elsewhere{};    ///< of the other units
    unsigned seed = 1;           ///< of voronoi sites
    /// Stiffness of a crack over that of the stone between two cracks, where they share that of
    /// the unit [-], > 1.
    double rigidity = 50.0;
    friend bool operator==(const UnitCracks&, const UnitCracks&) = default;
};

/// @param middle of a unit
[[nodiscard]] const CrackPattern& pattern_at(const UnitCracks& cracks, Point middle);

/// Whether pieces have cracks on all sides, so that pieces and cracks share the stiffness of
/// their unit (Layout::crack_rigidity). The others, parallel vertical lines, follow the paper:
/// they add to it.
[[nodiscard]] bool shares_stiffness(const CrackPattern& pattern);

/// The pieces of a unit, counter-clockwise, from the bottom to the top and from left to right;
/// one: it is not divided.
/// @param outline simple, counter-clockwise
/// @param unit_length of a whole unit [m]; 0: this is one
/// @param seed of voronoi sites
[[nodiscard]] std::vector<std::vector<Point>> pieces_of(const std::vector<Point>& outline,
                                                        const CrackPattern& pattern,
                                                        double unit_length, unsigned seed);

} // namespace dem
