#include "app/drawing/outlines/sides.hpp"
#include "app/drawing/trace/border_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace app {
namespace {

/// A straight line through `at`, of unit direction.
struct FittedLine {
    dem::Point at, along;

    [[nodiscard]] double across(dem::Point p) const
    {
        return (p.z - at.z) * along.x - (p.x - at.x) * along.z;
    }
    [[nodiscard]] double forward(dem::Point p) const
    {
        return (p.x - at.x) * along.x + (p.z - at.z) * along.z;
    }
};

/// The line with the least squares of the distances.
FittedLine fit_line(const std::vector<dem::Point>& points)
{
    const double n = static_cast<double>(points.size());
    dem::Point mean{};
    for (const dem::Point& p : points) mean = {mean.x + p.x / n, mean.z + p.z / n};
    double xx = 0.0, xz = 0.0, zz = 0.0;
    for (const dem::Point& p : points) {
        const double x = p.x - mean.x, z = p.z - mean.z;
        xx += x * x;
        xz += x * z;
        zz += z * z;
    }
    const double angle = 0.5 * std::atan2(2.0 * xz, xx - zz);
    return {mean, {std::cos(angle), std::sin(angle)}};
}

/// A border as a junction at one of its ends sees it.
struct Leaving {
    std::size_t chain = 0;
    std::vector<dem::Point>
        run; ///< from where the mortar no longer branches to the first corner
    std::vector<dem::Point> all; ///< of the border
    double slack = 0.0;          ///< by which a border between two branchings may bend [m]

    [[nodiscard]] bool tells(double tolerance) const
    {
        return run.size() >= 3 && distance(run.front(), run.back()) >= 2.0 * tolerance;
    }
};

// The middle of mortar that branches lies an eighth of its width off, a fifth of its distance
// from the stones.
constexpr double kBend = 0.25; // of a zone

/// Points of a chain between the zones of its two ends, in the order from junction j, up to the
/// first corner.
std::vector<dem::Point> run_from(const Chain& chain, int j, const std::vector<double>& zones,
                                 double tolerance)
{
    std::vector<dem::Point> points = chain.points;
    double near = zones[static_cast<std::size_t>(chain.from)],
           far = zones[static_cast<std::size_t>(chain.to)];
    if (chain.from != j) {
        std::reverse(points.begin(), points.end());
        std::swap(near, far);
    }
    const dem::Point first = points.front(), last = points.back();
    std::erase_if(points, [&](dem::Point p) {
        return distance(p, first) < near || distance(p, last) < far;
    });
    if (points.size() < 3) return {};
    std::size_t work = 0;
    const std::vector<dem::Point> kept = simplified(points, tolerance, work);
    const auto corner = std::ranges::find_if(
        points, [&](dem::Point p) { return p.x == kept[1].x && p.z == kept[1].z; });
    points.erase(corner + 1, points.end());
    return points;
}

/// The line of two borders that are one straight line on both sides of the junction, as closely
/// as the tolerance.
std::optional<FittedLine> common_line(const Leaving& one, const Leaving& other,
                                      double tolerance)
{
    std::vector<dem::Point> told;
    for (const Leaving* l : {&one, &other})
        if (l->tells(tolerance)) told.insert(told.end(), l->run.begin(), l->run.end());
    if (told.empty()) return {};
    const FittedLine line = fit_line(told);
    for (const Leaving* l : {&one, &other}) {
        const bool tells = l->tells(tolerance);
        for (const dem::Point& p : tells ? l->run : l->all)
            if (std::abs(line.across(p)) > tolerance + (tells ? 0.0 : l->slack)) return {};
    }
    const auto ends = [&](const Leaving& l) {
        const auto& points = l.tells(tolerance) ? l.run : l.all;
        return std::minmax(line.forward(points.front()), line.forward(points.back()));
    };
    const auto [a, b] = ends(one);
    const auto [c, d] = ends(other);
    const double common = std::min(b, d) - std::max(a, c);
    if (common > 0.5 * std::min(b - a, d - c)) return {}; // one beside the other
    return line;
}

/// Where a junction goes, and the two borders that are straight there.
struct Move {
    dem::Point to;
    std::size_t one = 0, other = 0;
};

std::optional<Move> move_of(const ChainNetwork& network, int j,
                            const std::vector<std::size_t>& chains,
                            const std::vector<double>& zones, double tolerance)
{
    std::vector<Leaving> leaving;
    for (const std::size_t c : chains) {
        const Chain& chain = network.chains[c];
        if (chain.from == chain.to || chain.on_frame()) return {};
        const double zone = std::max(zones[static_cast<std::size_t>(chain.from)],
                                     zones[static_cast<std::size_t>(chain.to)]);
        leaving.push_back(
            {c, run_from(chain, j, zones, tolerance), chain.points, kBend * zone});
    }
    const dem::Point at = network.junctions[static_cast<std::size_t>(j)].at;
    double least = std::max(tolerance, kBend * zones[static_cast<std::size_t>(j)]);
    std::optional<Move> found;
    for (std::size_t i = 0; i < leaving.size(); ++i)
        for (std::size_t k = i + 1; k < leaving.size(); ++k) {
            const auto line = common_line(leaving[i], leaving[k], tolerance);
            if (!line || std::abs(line->across(at)) > least) continue;
            least = std::abs(line->across(at));
            const double s = line->forward(at);
            found = Move{{line->at.x + s * line->along.x, line->at.z + s * line->along.z},
                         leaving[i].chain,
                         leaving[k].chain};
        }
    return found;
}

/// The end of a chain goes to another place, and the points within a radius of where it was go.
void move_end(Chain& chain, bool first, dem::Point to, double radius)
{
    std::vector<dem::Point>& p = chain.points;
    if (!first) std::reverse(p.begin(), p.end());
    const dem::Point was = p.front();
    const auto stays = std::find_if(p.begin() + 1, p.end() - 1,
                                    [&](dem::Point q) { return distance(q, was) >= radius; });
    p.erase(p.begin() + 1, stays);
    p.front() = to;
    if (!first) std::reverse(p.begin(), p.end());
}

} // namespace

std::size_t straighten_junctions(ChainNetwork& network, const std::vector<double>& zones,
                                 double tolerance)
{
    std::vector<std::vector<std::size_t>> chains(network.junctions.size());
    for (std::size_t c = 0; c < network.chains.size(); ++c) {
        if (network.chains[c].gone) continue;
        chains[static_cast<std::size_t>(network.chains[c].from)].push_back(c);
        chains[static_cast<std::size_t>(network.chains[c].to)].push_back(c);
    }
    std::vector<std::optional<Move>> moves(network.junctions.size());
    for (std::size_t j = 0; j < moves.size(); ++j)
        if (!network.junctions[j].on_frame && chains[j].size() > 2)
            moves[j] = move_of(network, static_cast<int>(j), chains[j], zones, tolerance);
    std::size_t moved = 0;
    for (std::size_t j = 0; j < moves.size(); ++j) {
        if (!moves[j]) continue;
        dem::Point& at = network.junctions[j].at;
        const double by = distance(at, moves[j]->to);
        for (const std::size_t c : chains[j]) {
            const bool straight = c == moves[j]->one || c == moves[j]->other;
            Chain& chain = network.chains[c];
            move_end(chain, chain.from == static_cast<int>(j), moves[j]->to,
                     straight ? std::max(zones[j], 2.0 * by) : 2.0 * by);
        }
        if (by > 0.0) ++moved;
        at = moves[j]->to;
    }
    return moved;
}

} // namespace app
