#include "dem/scene/geometry/clip.hpp"

#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dem {

namespace {

constexpr double kOnTheLine = 1e-9;     // [m]
constexpr double kSmallestPart = 1e-10; // [m2]

/// A stretch of outline on the kept side, from the line to the line.
struct Chain {
    Outline points;
    std::vector<bool> on_line; ///< of each point
    std::size_t next = 0;

    void add(Point p, bool on)
    {
        points.push_back(p);
        on_line.push_back(on);
    }
    [[nodiscard]] bool inside() const
    {
        return std::ranges::find(on_line, false) != on_line.end();
    }
    /// Leaves out sides along the line at either end: they bound what lies beyond.
    void trim()
    {
        const auto first = std::ranges::find(on_line, false) - on_line.begin();
        const auto last = on_line.rend() - std::find(on_line.rbegin(), on_line.rend(), false);
        points = Outline(points.begin() + first - 1, points.begin() + last + 1);
    }
};

Point crossing(Point a, Point b, double da, double db)
{
    const double s = da / (da - db);
    return {a.x + s * (b.x - a.x), a.z + s * (b.z - a.z)};
}

/// @param off distances of the corners from the line, positive beyond it; one at least is
std::vector<Chain> chains_of(const Outline& outline, const std::vector<double>& off)
{
    const std::size_t n = outline.size();
    const auto first = static_cast<std::size_t>(
        std::ranges::find_if(off, [](double d) { return d > 0.0; }) - off.begin());
    std::vector<Chain> chains;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = (first + k) % n, j = (i + 1) % n;
        const Point a = outline[i], b = outline[j];
        if (off[i] > 0.0 && off[j] > 0.0) continue;
        if (off[i] > 0.0) chains.emplace_back();
        Chain& chain = chains.back();
        if (off[i] > 0.0 && off[j] < 0.0) chain.add(crossing(a, b, off[i], off[j]), true);
        if (off[j] <= 0.0) chain.add(b, off[j] == 0.0);
        if (off[i] < 0.0 && off[j] > 0.0) chain.add(crossing(a, b, off[i], off[j]), true);
    }
    std::erase_if(chains, [](const Chain& c) { return !c.inside(); });
    for (Chain& c : chains) c.trim();
    return chains;
}

/// Along the line the inside of the outline lies between every other pair of ends.
void link(std::vector<Chain>& chains, Point along)
{
    struct End {
        double place;
        std::size_t chain;
        bool starts;
    };
    std::vector<End> ends;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const auto place = [&](Point p) { return p.x * along.x + p.z * along.z; };
        ends.push_back({place(chains[c].points.front()), c, true});
        ends.push_back({place(chains[c].points.back()), c, false});
    }
    std::ranges::stable_sort(ends, {}, &End::place);
    for (std::size_t e = 0; e + 1 < ends.size(); e += 2) {
        const End &one = ends[e].starts ? ends[e] : ends[e + 1],
                  &other = ends[e].starts ? ends[e + 1] : ends[e];
        chains[other.chain].next = one.chain;
    }
}

} // namespace

std::vector<Outline> clip(const Outline& outline, const HalfPlane& kept)
{
    std::vector<double> off;
    for (const Point p : outline) {
        const double d = (p.x - kept.at.x) * kept.normal.x + (p.z - kept.at.z) * kept.normal.z;
        off.push_back(std::abs(d) < kOnTheLine ? 0.0 : d);
    }
    if (std::ranges::none_of(off, [](double d) { return d > 0.0; })) return {outline};
    std::vector<Chain> chains = chains_of(outline, off);
    link(chains, {-kept.normal.z, kept.normal.x});
    std::vector<Outline> parts;
    std::vector<bool> done(chains.size(), false);
    for (std::size_t c = 0; c < chains.size(); ++c) {
        Outline part;
        for (std::size_t k = c; !done[k]; k = chains[k].next) {
            done[k] = true;
            part.insert(part.end(), chains[k].points.begin(), chains[k].points.end());
        }
        if (part.size() >= 3 && polygon_area(part) > kSmallestPart)
            parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<Outline> clip(const std::vector<Outline>& outlines, const HalfPlane& kept)
{
    std::vector<Outline> all;
    for (const Outline& o : outlines)
        for (Outline& part : clip(o, kept)) all.push_back(std::move(part));
    return all;
}

} // namespace dem
