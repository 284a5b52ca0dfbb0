#include "app/drawing/outlines/sides.hpp"
#include "app/drawing/trace/border_chains.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace app {
namespace {

double length_of(const Chain& chain)
{
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < chain.points.size(); ++i)
        length += distance(chain.points[i], chain.points[i + 1]);
    return length;
}

/// Areas and chains that meet at each junction, while chains are closed.
struct Meeting {
    std::vector<std::set<int>> areas;  ///< at each junction; kMortar is the surroundings
    std::vector<std::set<int>> chains; ///< at each junction
    std::vector<int> borders;          ///< of each stone
};

Meeting meeting_of(const ChainNetwork& network, int stones)
{
    Meeting m{std::vector<std::set<int>>(network.junctions.size()),
              std::vector<std::set<int>>(network.junctions.size()),
              std::vector<int>(static_cast<std::size_t>(stones))};
    for (std::size_t c = 0; c < network.chains.size(); ++c) {
        const Chain& chain = network.chains[c];
        for (const int j : {chain.from, chain.to}) {
            m.areas[j].insert({chain.left, chain.right});
            m.chains[j].insert(static_cast<int>(c));
        }
        for (const int area : {chain.left, chain.right})
            if (area != kMortar) ++m.borders[area];
    }
    return m;
}

bool can_close(const ChainNetwork& network, const Meeting& m, const Chain& chain)
{
    constexpr int kLeastBorders = 3; // that a stone keeps
    const auto from = static_cast<std::size_t>(chain.from),
               to = static_cast<std::size_t>(chain.to);
    if (chain.from == chain.to || chain.on_frame()) return false;
    if (network.junctions[from].on_frame && network.junctions[to].on_frame) return false;
    for (const int area : {chain.left, chain.right})
        if (m.borders[area] <= kLeastBorders) return false;
    std::vector<int> common; // a third area at both ends would touch itself
    std::set_intersection(m.areas[from].begin(), m.areas[from].end(), m.areas[to].begin(),
                          m.areas[to].end(), std::back_inserter(common));
    return common.size() == 2;
}

void close_chain(ChainNetwork& network, Meeting& m, int c)
{
    Chain& chain = network.chains[c];
    const auto stays = static_cast<std::size_t>(chain.from),
               goes = static_cast<std::size_t>(chain.to);
    Junction &kept = network.junctions[stays], &lost = network.junctions[goes];
    if (lost.on_frame)
        kept = lost;
    else if (!kept.on_frame)
        kept.at = {0.5 * (kept.at.x + lost.at.x), 0.5 * (kept.at.z + lost.at.z)};
    for (const int area : {chain.left, chain.right}) --m.borders[area];
    chain.gone = true;
    m.areas[stays].insert(m.areas[goes].begin(), m.areas[goes].end());
    m.chains[stays].insert(m.chains[goes].begin(), m.chains[goes].end());
    m.chains[stays].erase(c);
    for (const int other : m.chains[stays]) {
        Chain& moved = network.chains[other];
        if (moved.from == static_cast<int>(goes)) moved.from = static_cast<int>(stays);
        if (moved.to == static_cast<int>(goes)) moved.to = static_cast<int>(stays);
        if (moved.from == static_cast<int>(stays)) moved.points.front() = kept.at;
        if (moved.to == static_cast<int>(stays)) moved.points.back() = kept.at;
    }
}

} // namespace

std::size_t close_short_chains(ChainNetwork& network, int stones, double least)
{
    Meeting m = meeting_of(network, stones);
    std::vector<std::pair<double, int>> order;
    for (std::size_t c = 0; c < network.chains.size(); ++c)
        order.emplace_back(length_of(network.chains[c]), static_cast<int>(c));
    std::ranges::sort(order);
    std::size_t closed = 0;
    for (const auto& [length, c] : order) {
        const Chain& chain = network.chains[c];
        if (length >= least) break;
        if (length_of(chain) >= least || !can_close(network, m, chain)) continue;
        close_chain(network, m, c);
        ++closed;
    }
    return closed;
}

} // namespace app
