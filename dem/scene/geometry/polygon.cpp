#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dem {

namespace {

/// Corners are taken from the first one, so that far from the origin no digits are lost.
template <class Visit> void each_side(std::span<const Point> outline, Visit visit)
{
    const Point origin = outline.front();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a = outline[i], b = outline[(i + 1) % outline.size()];
        visit(Point{a.x - origin.x, a.z - origin.z}, Point{b.x - origin.x, b.z - origin.z});
    }
}

} // namespace

Region extent_of(std::span<const Point> points)
{
    const auto [left, right] = std::ranges::minmax(points, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax(points, {}, &Point::z);
    return {left.x, low.z, right.x, high.z};
}

Region join(const Region& a, const Region& b)
{
    return {std::min(a.x0, b.x0), std::min(a.z0, b.z0), std::max(a.x1, b.x1),
            std::max(a.z1, b.z1)};
}

double polygon_area(std::span<const Point> outline)
{
    double twice = 0.0;
    each_side(outline, [&](Point a, Point b) { twice += a.x * b.z - b.x * a.z; });
    return 0.5 * twice;
}

Point polygon_centre(std::span<const Point> outline)
{
    double twice = 0.0, x = 0.0, z = 0.0;
    each_side(outline, [&](Point a, Point b) {
        const double cross = a.x * b.z - b.x * a.z;
        twice += cross;
        x += (a.x + b.x) * cross;
        z += (a.z + b.z) * cross;
    });
    return {outline.front().x + x / (3.0 * twice), outline.front().z + z / (3.0 * twice)};
}

bool is_inside(std::span<const Point> outline, Point at)
{
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Point a = outline[i], b = outline[j];
        if ((a.z > at.z) == (b.z > at.z)) continue;
        if (at.x < a.x + (b.x - a.x) * (at.z - a.z) / (b.z - a.z)) inside = !inside;
    }
    return inside;
}

double distance_to_segment(Point at, Point from, Point to)
{
    const double dx = to.x - from.x, dz = to.z - from.z, square = dx * dx + dz * dz;
    const double s =
        square > 0.0
            ? std::clamp(((at.x - from.x) * dx + (at.z - from.z) * dz) / square, 0.0, 1.0)
            : 0.0;
    return std::hypot(at.x - from.x - s * dx, at.z - from.z - s * dz);
}

} // namespace dem
