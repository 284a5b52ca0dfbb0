#include "app/drawing/outlines/sides.hpp"
#include "app/drawing/trace/border_chains.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

std::vector<dem::Point> simplified(const std::vector<dem::Point>& points, double tolerance,
                                   std::size_t& work)
{
    constexpr std::size_t kMostWork = 300'000'000; // a few seconds
    std::vector<char> keep(points.size());
    keep.front() = keep.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{
        {0, points.size() - 1}}; // in place of recursion
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        work += last - first;
        if (work > kMostWork) throw TooCrowded(points[first]);
        double most = std::max(tolerance, 1e-12);
        std::size_t farthest = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double d =
                nearest_on_segment(points[i], points[first], points[last]).distance;
            if (d <= most) continue;
            most = d;
            farthest = i;
        }
        if (farthest == first) continue;
        keep[farthest] = 1;
        open.emplace_back(first, farthest);
        open.emplace_back(farthest, last);
    }
    std::vector<dem::Point> kept;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (keep[i]) kept.push_back(points[i]);
    return kept;
}

namespace {

/// All chains as sides between nodes; junctions are the first nodes.
struct ChainSides {
    std::vector<dem::Point> nodes;
    std::vector<Side> sides;
    std::vector<std::size_t> chain; ///< of each side
};

ChainSides sides_of(const ChainNetwork& network,
                    const std::vector<std::vector<dem::Point>>& points)
{
    ChainSides all;
    for (const Junction& junction : network.junctions) all.nodes.push_back(junction.at);
    for (std::size_t c = 0; c < points.size(); ++c) {
        if (network.chains[c].gone) continue;
        int last = network.chains[c].from;
        for (std::size_t i = 1; i < points[c].size(); ++i) {
            int next = network.chains[c].to;
            if (i + 1 < points[c].size()) {
                next = static_cast<int>(all.nodes.size());
                all.nodes.push_back(points[c][i]);
            }
            all.sides.push_back({std::min(last, next), std::max(last, next)});
            all.chain.push_back(c);
            last = next;
        }
    }
    return all;
}

/// Marks the chains that cross, touch or cover each other.
bool mark_conflicts(const ChainSides& all, std::vector<char>& marked)
{
    constexpr double kTouching = 1e-6; // [m]
    bool any = false;
    const auto mark = [&](std::size_t side) {
        marked[all.chain[side]] = 1;
        any = true;
    };
    for (const Crossing& crossing : all_crossings(all.nodes, all.sides)) {
        mark(static_cast<std::size_t>(crossing.first));
        mark(static_cast<std::size_t>(crossing.second));
    }
    const std::vector<std::vector<int>> touching =
        nodes_on_sides(all.nodes, all.sides, kTouching);
    std::vector<std::vector<std::size_t>> sides_at(all.nodes.size());
    for (std::size_t s = 0; s < all.sides.size(); ++s)
        for (const int n : {all.sides[s].a, all.sides[s].b}) sides_at[n].push_back(s);
    for (std::size_t s = 0; s < touching.size(); ++s)
        for (const int n : touching[s]) {
            mark(s);
            for (const std::size_t other : sides_at[n]) mark(other);
        }
    std::vector<std::pair<Side, std::size_t>> sorted;
    for (std::size_t s = 0; s < all.sides.size(); ++s) sorted.emplace_back(all.sides[s], s);
    std::ranges::sort(sorted);
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
        if (sorted[i].first != sorted[i + 1].first) continue;
        mark(sorted[i].second);
        mark(sorted[i + 1].second);
    }
    return any;
}

} // namespace

SimplifiedChains simplify_chains(const ChainNetwork& network, double tolerance)
{
    constexpr int kHalvings = 6; // then no point but those on straight lines goes
    SimplifiedChains result;
    std::size_t work = 0;
    result.points.resize(network.chains.size());
    std::vector<int> halved(network.chains.size());
    std::vector<char> marked(network.chains.size(), 1);
    for (int round = 0; round <= 2 * kHalvings; ++round) {
        for (std::size_t c = 0; c < network.chains.size(); ++c) {
            if (!marked[c] || network.chains[c].gone) continue;
            const double own = halved[c] > kHalvings ? 0.0 : std::ldexp(tolerance, -halved[c]);
            result.points[c] = simplified(network.chains[c].points, own, work);
        }
        std::ranges::fill(marked, 0);
        result.crossing = mark_conflicts(sides_of(network, result.points), marked);
        if (!result.crossing) break;
        for (std::size_t c = 0; c < marked.size(); ++c)
            if (marked[c]) ++halved[c];
    }
    result.finer =
        static_cast<std::size_t>(std::ranges::count_if(halved, [](int n) { return n > 0; }));
    return result;
}

} // namespace app
