#include "app/scene/scene_units.hpp"

#include "dem/scene/touching.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace app {
namespace {

using Outline = std::vector<dem::Point>;

constexpr double kSame = 1e-9; // [m]

bool same(dem::Point a, dem::Point b) { return std::hypot(a.x - b.x, a.z - b.z) < kSame; }

/// Whether b lies on the straight line from a to c.
bool straight(dem::Point a, dem::Point b, dem::Point c)
{
    const double dx = c.x - a.x, dz = c.z - a.z;
    return std::abs(dx * (b.z - a.z) - dz * (b.x - a.x)) < kSame * std::hypot(dx, dz);
}

/// Without two of its corners where the outline runs straight on.
Outline without(const Outline& outline, dem::Point end, dem::Point other)
{
    Outline kept;
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        const dem::Point p = outline[i];
        const bool cut = same(p, end) || same(p, other);
        if (!cut || !straight(outline[(i + n - 1) % n], p, outline[(i + 1) % n]))
            kept.push_back(p);
    }
    return kept;
}

/// Both parts of a unit as one outline; empty if they have no side in common.
Outline joined(const Outline& a, const Outline& b)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const dem::Point p = a[i], q = a[(i + 1) % a.size()];
            if (!same(p, b[(j + 1) % b.size()]) || !same(q, b[j])) continue;
            Outline all;
            for (std::size_t k = 1; k <= a.size(); ++k)
                all.push_back(a[(i + k) % a.size()]); // from q to p
            for (std::size_t k = 2; k < b.size(); ++k)
                all.push_back(b[(j + k) % b.size()]); // beyond p, before q
            return without(all, p, q);
        }
    return {};
}

std::string layer_of(const Study& study, int material)
{
    const auto at = static_cast<std::size_t>(material - 1);
    return material > 0 && at < study.geometry.layers.size() ? study.geometry.layers[at]
                                                             : "wall";
}

} // namespace

std::vector<DrawnBlock> scene_units(const Study& study, const dem::Layout& layout)
{
    std::vector<DrawnBlock> units;
    int last = 0;
    for (int b = 0; b < layout.beam; ++b) {
        const dem::Block& block = layout.blocks[static_cast<std::size_t>(b)];
        const Outline part = dem::corners_of(block);
        if (block.unit == last)
            if (Outline whole = joined(units.back().outline, part); !whole.empty()) {
                units.back().outline = std::move(whole);
                continue;
            }
        last = block.unit;
        units.push_back({part, layer_of(study, block.material), ""});
    }
    return units;
}

} // namespace app
