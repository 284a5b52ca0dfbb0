#include "app/drawing/outlines/outline_network.hpp"

#include <algorithm>
#include <utility>

namespace app {
namespace {

/// A ring as a cyclic list, with the corners left out after each that stays.
struct ThinnedRing {
    std::vector<std::size_t> before, after; ///< neighbours of each corner that stays
    std::vector<std::vector<int>> left_out; ///< between a corner and the next
    std::size_t size = 0;                   ///< corners that stay
};

/// True if the corner, and all left out beside it, are within snap of the straight line between
/// its neighbours.
bool is_straight(const OutlineNetwork& network, const std::vector<int>& corners,
                 const ThinnedRing& thin, std::size_t i)
{
    constexpr std::size_t kMost = 2000; // on one straight line; keeps the cost in bounds
    const auto at = [&](int n) { return network.nodes[n]; };
    const dem::Point a = at(corners[thin.before[i]]), b = at(corners[thin.after[i]]);
    const std::vector<int>&one = thin.left_out[thin.before[i]], &other = thin.left_out[i];
    if (one.size() + other.size() > kMost) return false;
    const auto near = [&](int n) {
        return nearest_on_segment(at(n), a, b).distance <= network.snap;
    };
    return near(corners[i]) && std::ranges::all_of(one, near) &&
           std::ranges::all_of(other, near);
}

void leave_out(const std::vector<int>& corners, ThinnedRing& thin, std::size_t i)
{
    std::vector<int>& kept = thin.left_out[thin.before[i]];
    kept.push_back(corners[i]);
    kept.insert(kept.end(), thin.left_out[i].begin(), thin.left_out[i].end());
    thin.after[thin.before[i]] = thin.after[i];
    thin.before[thin.after[i]] = thin.before[i];
    --thin.size;
}

std::vector<int> straightened(const OutlineNetwork& network, const std::vector<int>& corners,
                              const std::vector<std::vector<int>>& rings)
{
    const std::size_t n = corners.size();
    ThinnedRing thin{std::vector<std::size_t>(n), std::vector<std::size_t>(n),
                     std::vector<std::vector<int>>(n), n};
    for (std::size_t i = 0; i < n; ++i) {
        thin.before[i] = (i + n - 1) % n;
        thin.after[i] = (i + 1) % n;
    }
    std::vector<char> gone(n);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < n; ++i) {
            if (gone[i] || thin.size <= 3 || rings[corners[i]].size() > 1) continue;
            if (!is_straight(network, corners, thin, i)) continue;
            leave_out(corners, thin, i);
            gone[i] = 1;
            changed = true;
        }
    }
    std::vector<int> kept;
    for (std::size_t i = 0; i < n; ++i)
        if (!gone[i]) kept.push_back(corners[i]);
    return kept;
}

} // namespace

std::size_t straighten(OutlineNetwork& network)
{
    const std::vector<std::vector<int>> rings = rings_of_nodes(network);
    std::size_t n = 0;
    for (Ring& ring : network.rings) {
        std::vector<int> kept = straightened(network, ring.corners, rings);
        n += ring.corners.size() - kept.size();
        ring.corners = std::move(kept);
    }
    return n;
}

} // namespace app
