#include "app/drawing/outlines/arc_pieces.hpp"

#include "app/drawing/outlines/sides.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace app {

std::vector<dem::Point> arc_points(dem::Point centre, double radius, double begin, double sweep,
                                   double off)
{
    constexpr double kSmallest = std::numbers::pi / 360.0; // angle of a piece [rad]
    const double rise = std::clamp(off / radius, 0.0, 1.0),
                 piece = std::max(kSmallest, 2.0 * std::acos(1.0 - rise));
    const double n = std::max(1.0, std::ceil(std::abs(sweep) / piece * (1.0 - 1e-9)));
    std::vector<dem::Point> points;
    for (double i = 0.0; i <= n; ++i) {
        const double angle = begin + sweep * i / n;
        points.push_back(
            {centre.x + radius * std::cos(angle), centre.z + radius * std::sin(angle)});
    }
    return points;
}

std::vector<dem::Point> bulge_points(dem::Point from, dem::Point to, double bulge, double off)
{
    // programs that straighten arcs leave values such as 1e-12
    constexpr double kStraight = 1e-7;
    const double chord = distance(from, to);
    if (std::abs(bulge) <= kStraight || !(chord > 0.0)) return {};
    const double aside = (1.0 - bulge * bulge) / (4.0 * bulge); // over the chord, to its left
    const dem::Point centre{0.5 * (from.x + to.x) - aside * (to.z - from.z),
                            0.5 * (from.z + to.z) + aside * (to.x - from.x)};
    std::vector<dem::Point> points = arc_points(
        centre, distance(centre, from), std::atan2(from.z - centre.z, from.x - centre.x),
        4.0 * std::atan(bulge), off);
    points.pop_back();
    points.erase(points.begin());
    return points;
}

} // namespace app
