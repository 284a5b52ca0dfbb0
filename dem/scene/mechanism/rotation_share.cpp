#include "dem/scene/mechanism/rotation_share.hpp"

#include "dem/scene/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dem {

namespace {

bool is_beam(const BlockState& block) { return block.unit == 0; }

/// The part of a block that counts at each level that it reaches.
struct Turning {
    double z0 = 0.0, z1 = 0.0; ///< extent [m]
    double weight = 0.0;       ///< mean width x horizontal displacement [m2]
    double rotation = 0.0;     ///< sine of the angle, positive to the right [-]
};

/// The rotation that fits the displacements of the outline best.
Turning turning_of(const BlockState& block)
{
    const auto n = static_cast<double>(block.outline.size());
    Point middle, moved;
    for (std::size_t p = 0; p < block.outline.size(); ++p) {
        middle = {middle.x + block.outline[p].x / n, middle.z + block.outline[p].z / n};
        moved = {moved.x + block.displacement[p].x / n, moved.z + block.displacement[p].z / n};
    }
    double turn = 0.0, squares = 0.0;
    for (std::size_t p = 0; p < block.outline.size(); ++p) {
        const Point arm{block.outline[p].x - middle.x, block.outline[p].z - middle.z};
        turn += arm.z * (block.displacement[p].x - moved.x) -
                arm.x * (block.displacement[p].z - moved.z);
        squares += arm.x * arm.x + arm.z * arm.z;
    }
    const auto [low, high] = std::ranges::minmax(block.outline, {}, &Point::z);
    const double width = polygon_area(block.outline) / (high.z - low.z);
    return {low.z, high.z, width * std::abs(moved.x), turn / squares};
}

/// Heights between which every block reaches through or does not, up to that of the load line
/// [m].
std::vector<double> levels_of(const std::vector<Turning>& blocks, double height)
{
    std::vector<double> levels{0.0, height};
    for (const Turning& b : blocks)
        for (const double z : {b.z0, b.z1})
            if (z > 0.0 && z < height) levels.push_back(z);
    std::ranges::sort(levels);
    return levels;
}

} // namespace

std::optional<double> beam_rotation_share(const Snapshot& wall, double height)
{
    const BlockState& beam = wall.blocks.back();
    if (!is_beam(beam)) return std::nullopt;
    const auto [left, right] = std::ranges::minmax_element(beam.outline, {}, &Point::x);
    const auto l = left - beam.outline.begin(), r = right - beam.outline.begin();
    const double rotation =
        (beam.displacement[l].z - beam.displacement[r].z) / (right->x - left->x);
    return rotation * height / wall.displacement;
}

double turning_share(const Snapshot& wall, double height, Turns turns_count)
{
    std::vector<Turning> blocks;
    for (const BlockState& b : wall.blocks) blocks.push_back(turning_of(b));
    if (turns_count == Turns::to_either_side)
        for (Turning& b : blocks) b.rotation = std::copysign(b.rotation, wall.displacement);
    const double top = std::ranges::max(blocks, {}, &Turning::z1).z1;
    if (turns_count == Turns::to_either_side) height = std::max(height, top);
    if (top < height) // the load line lies above all: its way is that of what lies highest
        for (Turning& b : blocks)
            if (b.z1 == top) b.z1 = height;
    const std::vector<double> levels = levels_of(blocks, height);
    double sum = 0.0;
    for (std::size_t i = 1; i < levels.size(); ++i) {
        const double middle = 0.5 * (levels[i - 1] + levels[i]);
        double weights = 0.0, turns = 0.0;
        for (const Turning& b : blocks)
            if (b.z0 < middle && middle < b.z1) {
                weights += b.weight;
                turns += b.weight * b.rotation;
            }
        if (weights > 0.0) sum += turns / weights * (levels[i] - levels[i - 1]);
    }
    return sum / wall.displacement;
}

} // namespace dem
