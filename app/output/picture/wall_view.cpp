#include "app/output/picture/wall_view.hpp"

#include "dem/scene/mechanism/block_displacement.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace app {

namespace {

double larger_side(const WallBox& box)
{
    return std::max(box.high.x - box.low.x, box.high.z - box.low.z);
}

/// Largest of 1, 2, 3, 5 times a power of ten that is at most `x`, within [1, 1000].
double round_down(double x)
{
    double best = 1.0;
    for (const double decade : {1.0, 10.0, 100.0, 1000.0})
        for (const double step : {1.0, 2.0, 3.0, 5.0})
            if (decade * step <= std::min(x, 1000.0)) best = decade * step;
    return best;
}

} // namespace

Pixel WallView::place(dem::Point at, dem::Point u) const
{
    return {origin.x + pixels_per_metre * (at.x + scale * u.x),
            origin.y - pixels_per_metre * (at.z + scale * u.z)};
}

WallBox box_of(std::span<const dem::BlockState> blocks, double scale)
{
    constexpr double kFar = std::numeric_limits<double>::infinity();
    WallBox box{{kFar, kFar}, {-kFar, -kFar}};
    for (const dem::BlockState& block : blocks)
        for (std::size_t i = 0; i < block.outline.size(); ++i) {
            const double x = block.outline[i].x + scale * block.displacement.at(i).x;
            const double z = block.outline[i].z + scale * block.displacement.at(i).z;
            box = join(box, {{x, z}, {x, z}});
        }
    if (!(larger_side(box) > 0.0 && larger_side(box) < kFar))
        throw std::invalid_argument("wall picture: no blocks, or their size is not finite");
    return box;
}

WallBox join(const WallBox& a, const WallBox& b)
{
    return {{std::min(a.low.x, b.low.x), std::min(a.low.z, b.low.z)},
            {std::max(a.high.x, b.high.x), std::max(a.high.z, b.high.z)}};
}

double drawing_scale(const dem::Snapshot& wall)
{
    const WallBox rest = box_of(wall.blocks, 0.0);
    const double size = std::min(rest.high.x - rest.low.x, rest.high.z - rest.low.z);
    constexpr double kSmall =
        1e-12; // [m] a wall at rest is drawn at the largest scale, and looks at rest
    const double by_displacement = 0.15 * size / std::max(largest_displacement(wall), kSmall);
    const double by_joint = 0.12 * size / std::max(largest_movement(wall), kSmall);
    return round_down(std::min(by_displacement, by_joint));
}

ContactPixels place_contact(const dem::Snapshot& wall, const WallView& view,
                            const dem::FaceState& face, const dem::ContactState& contact)
{
    const Pixel a =
        view.place(contact.at, dem::displacement_at(wall, face.block_a, contact.at));
    const Pixel b =
        view.place(contact.at, dem::displacement_at(wall, face.block_b, contact.at));
    return {a, b, {(a.x + b.x) / 2, (a.y + b.y) / 2}};
}

} // namespace app
