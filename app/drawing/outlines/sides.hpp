#pragma once
/// Sides between corners that several blocks share: which corners are one, which lie on a side,
/// which sides cross.

#include "dem/scene/geometry/snapshot.hpp"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace app {

/// A piece of a drawing holds so much that comparing it would take minutes; `at` says where.
struct TooCrowded : std::runtime_error {
    explicit TooCrowded(dem::Point where)
        : std::runtime_error("too many corners in one place"), at(where)
    {
    }
    dem::Point at;
};

/// Indices from 0 in sets, each of which is named by its first.
class IndexSets {
  public:
    explicit IndexSets(std::size_t n) : parent_(n)
    {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    [[nodiscard]] int first_of(int i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void unite(int i, int j)
    {
        const int a = first_of(i), b = first_of(j);
        parent_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<int> parent_;
};

struct Welded {
    std::vector<int> node; ///< of each point: index of the first point that it coincides with
    double farthest = 0.0; ///< largest distance between a point and its node [m]
    std::size_t farthest_point = 0;
    std::size_t moved = 0; ///< points more than 1e-9 m from their node
};

/// Points within `snap` of each other are one, and so are those that others connect; the first
/// of them stays where it is. Nodes are more than `snap` apart afterwards.
/// @throws TooCrowded
[[nodiscard]] Welded weld(std::span<const dem::Point> points, double snap);

/// Two nodes; a side of one block or of two.
struct Side {
    int a = 0, b = 0;
    friend auto operator<=>(const Side&, const Side&) = default;
};

/// [m], or in the unit of the points
[[nodiscard]] double distance(dem::Point a, dem::Point b);

/// The point of a segment that is nearest to another.
struct OnSegment {
    double share = 0.0;    ///< where on the segment [-], in [0, 1]
    double distance = 0.0; ///< from the other point, in the unit of the points
};
[[nodiscard]] OnSegment nearest_on_segment(dem::Point p, dem::Point a, dem::Point b);

/// For each side the nodes within `snap` of it that are not its ends, in the order from a to b.
/// Only nodes that a side has are looked at.
/// @throws TooCrowded
[[nodiscard]] std::vector<std::vector<int>>
nodes_on_sides(std::span<const dem::Point> nodes, std::span<const Side> sides, double snap);

struct Crossing {
    int first = 0, second = 0; ///< indices of sides, first < second
    dem::Point at;
};

/// The crossing whose sides come first, of sides that share no node.
/// @throws TooCrowded
[[nodiscard]] std::optional<Crossing> first_crossing(std::span<const dem::Point> nodes,
                                                     std::span<const Side> sides);

/// Every crossing of sides that share no node, each once, in order.
/// @throws TooCrowded
[[nodiscard]] std::vector<Crossing> all_crossings(std::span<const dem::Point> nodes,
                                                  std::span<const Side> sides);

} // namespace app
