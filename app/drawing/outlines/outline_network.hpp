#pragma once
/// Outlines that share corners.

#include "app/drawing/outlines/raw_drawing.hpp"
#include "app/drawing/outlines/sides.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace app {

struct Ring {
    std::vector<int> corners; ///< indices of nodes
    std::string layer;
    int line = 0; ///< of the file, from 1
};

struct OutlineNetwork {
    DrawingFrame frame;
    double snap = 0.0;             ///< [m], at least kLeastSnap
    std::vector<dem::Point> nodes; ///< [m]; not all are used
    std::vector<Ring> rings;
    std::vector<std::string> notes;
};

constexpr double kLeastSnap =
    1e-7; // [m]; closer than this, corners and sides are the same to the solver

/// The sides of all rings, each once with a < b, and one ring that each belongs to.
struct NetworkSides {
    std::vector<Side> sides;
    std::vector<int> ring;
};
[[nodiscard]] NetworkSides network_sides(const OutlineNetwork& network);

/// The rings that have each node, in order.
[[nodiscard]] std::vector<std::vector<int>> rings_of_nodes(const OutlineNetwork& network);

/// The places of a ring's corners [m].
[[nodiscard]] std::vector<dem::Point> outline_of(const OutlineNetwork& network,
                                                 const Ring& ring);

/// "wall.snap (0.5 mm)"; where the user has no such key "0.002 mm".
[[nodiscard]] std::string snap_text(const OutlineNetwork& network);

/// The advice, which is about wall.snap, if the user has that key.
[[nodiscard]] std::string snap_advice(const OutlineNetwork& network, std::string_view advice);

/// "the block of line 12", or of its first corner where the file has no lines.
[[nodiscard]] std::string block_name(const OutlineNetwork& network, const Ring& ring);

/// Joins corners that coincide within snap, puts corners within snap of another block's side
/// onto it (the side gets that corner too), and those that follow the lowest or the highest
/// corner within snap onto its level; leaves out corners on straight lines that no other block
/// has.
/// @throws ConfigError where an outline is smaller than snap, or comes within snap of itself
void fit_corners(OutlineNetwork& network);

/// Leaves out corners that lie within snap of the straight line between those beside them and
/// that one block alone has. Returns how many.
std::size_t straighten(OutlineNetwork& network);

/// Turns all rings counter-clockwise.
/// @throws ConfigError for outlines that cross themselves, have no area, overlap, lie within
/// each other, or stand on
/// nothing
void check_outlines(OutlineNetwork& network);

/// The part of it that looks at blocks as groups: what lies within another block, or hangs
/// together with none on the floor. Takes for granted that no sides cross and that the blocks
/// around each corner lie one after the other.
/// @throws ConfigError
void check_groups(const OutlineNetwork& network);

/// Adds notes of gaps a little wider than snap.
void note_gaps(OutlineNetwork& network);

} // namespace app
