#include "app/drawing/trace/border_chains.hpp"

#include <algorithm>
#include <map>

namespace app {
namespace {

/// A chain as one stone sees it.
struct OwnChain {
    std::size_t chain = 0;
    bool forward = true; ///< so that the stone is on the left
};

std::vector<dem::Point> ring_of(const DrawingFrame& frame, const ChainNetwork& network,
                                const SimplifiedChains& simplified,
                                const std::vector<OwnChain>& own)
{
    std::map<int, OwnChain> leaving;
    for (const OwnChain& o : own) {
        const Chain& chain = network.chains[o.chain];
        leaving[o.forward ? chain.from : chain.to] = o;
    }
    std::vector<dem::Point> ring;
    const int first = leaving.begin()->first;
    int at = first;
    std::size_t walked = 0;
    do {
        const auto next = leaving.find(at);
        if (next == leaving.end() || ++walked > own.size()) break;
        const Chain& chain = network.chains[next->second.chain];
        std::vector<dem::Point> points = simplified.points[next->second.chain];
        if (!next->second.forward) std::ranges::reverse(points);
        ring.insert(ring.end(), points.begin(), points.end() - 1);
        at = next->second.forward ? chain.to : chain.from;
    } while (at != first);
    if (walked == own.size() && at == first) return ring;
    refuse(frame, 0,
           "a stone at " + raw_coordinates(frame, {ring.front().x, ring.front().z}) +
               " m encloses others or touches itself; divide it by mortar, or fill what it "
               "encloses");
}

} // namespace

std::vector<std::vector<dem::Point>> outlines_of(const DrawingFrame& frame,
                                                 const ChainNetwork& network,
                                                 const SimplifiedChains& simplified, int stones)
{
    std::vector<std::vector<OwnChain>> own(static_cast<std::size_t>(stones));
    for (std::size_t c = 0; c < network.chains.size(); ++c) {
        const Chain& chain = network.chains[c];
        if (chain.gone) continue;
        if (chain.left != kMortar) own[chain.left].push_back({c, true});
        if (chain.right != kMortar) own[chain.right].push_back({c, false});
    }
    std::vector<std::vector<dem::Point>> outlines;
    for (const std::vector<OwnChain>& chains : own)
        outlines.push_back(ring_of(frame, network, simplified, chains));
    return outlines;
}

} // namespace app
