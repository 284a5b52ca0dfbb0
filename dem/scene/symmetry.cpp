#include "dem/scene/symmetry.hpp"

#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dem {
namespace {

/// A block or a crack, told by its middle, its size and its material.
struct Mark {
    Point middle;             ///< [m]
    double size = 0.0;        ///< area of a block [m2], length of a crack [m]
    double half_length = 0.0; ///< along the wall [m]
    int material = 0;         ///< -1 of a crack
    int block = -1;           ///< -1 of a crack
};

std::vector<Mark> marks_of(const Layout& layout)
{
    std::vector<Mark> marks;
    for (int k = 0; k < static_cast<int>(layout.blocks.size()); ++k) {
        const Block& b = layout.blocks[k];
        if (k != layout.beam)
            marks.push_back({centre_of(b), area_of(b), 0.5 * (b.x1 - b.x0), b.material, k});
    }
    for (const Face& f : layout.faces)
        if (f.kind == FaceKind::unit_crack)
            marks.push_back({{0.5 * (f.from.x + f.to.x), 0.5 * (f.from.z + f.to.z)},
                             std::hypot(f.to.x - f.from.x, f.to.z - f.from.z),
                             0.5 * std::abs(f.to.x - f.from.x),
                             -1,
                             -1});
    std::ranges::sort(marks, {}, [](const Mark& m) { return m.middle.z; });
    return marks;
}

/// Whether the mirror image of each corner of a block lies on the outline of the other.
bool is_mirrored(const Block& block, const Block& other, double axis, double close)
{
    const std::vector<Point> outline = corners_of(other), corners = corners_of(block);
    return std::ranges::all_of(corners, [&](Point p) {
        p.x = 2.0 * axis - p.x;
        for (std::size_t i = 0; i < outline.size(); ++i)
            if (distance_to_segment(p, outline[i], outline[(i + 1) % outline.size()]) < close)
                return true;
        return false;
    });
}

/// The middle of the masonry [m].
double middle_of(const Layout& layout)
{
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (int k = 0; k < static_cast<int>(layout.blocks.size()); ++k) {
        if (k == layout.beam) continue;
        left = std::min(left, layout.blocks[k].x0);
        right = std::max(right, layout.blocks[k].x1);
    }
    return 0.5 * (left + right);
}

} // namespace

bool is_symmetric(const Layout& layout)
{
    constexpr double kClose = 1e-5; // [m], [m2]: rounding of drawings that are welded to 1e-6 m
    const std::vector<Mark> marks = marks_of(layout);
    const double axis = middle_of(layout);
    const auto close = [](double a, double b) { return std::abs(a - b) < kClose; };
    return std::ranges::all_of(marks, [&](const Mark& m) {
        auto other = std::ranges::lower_bound(marks, m.middle.z - kClose, {},
                                              [](const Mark& o) { return o.middle.z; });
        for (; other != marks.end() && other->middle.z < m.middle.z + kClose; ++other)
            if (close(other->middle.x + m.middle.x, 2.0 * axis) && close(other->size, m.size) &&
                close(other->half_length, m.half_length) && other->material == m.material &&
                (m.block < 0 || is_mirrored(layout.blocks[m.block], layout.blocks[other->block],
                                            axis, kClose)))
                return true;
        return false;
    });
}

} // namespace dem
