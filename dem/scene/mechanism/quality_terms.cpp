#include "dem/scene/mechanism/quality_terms.hpp"

#include <algorithm>
#include <cmath>

namespace dem {
namespace {

constexpr double kMiddle = 0.2, kLong = 0.4;      // of a unit [m]
constexpr double kStaggered = 1.6, kPartly = 1.4; // trace over height
constexpr double kSlack = 1e-6;                   // [m], and of a share

Fulfilled dimensions_of(const QualityTerms& t)
{
    if (t.long_stones > 0.5 + kSlack) return Fulfilled::fully;
    const double small = 1.0 - t.long_stones - t.middle_stones;
    return small > 0.5 + kSlack ? Fulfilled::no : Fulfilled::partly;
}

/// Where no way leads through joints, all are staggered.
Fulfilled staggering_of(double trace_ratio)
{
    if (std::isnan(trace_ratio) || trace_ratio > kStaggered) return Fulfilled::fully;
    return trace_ratio >= kPartly ? Fulfilled::partly : Fulfilled::no;
}

} // namespace

QualityTerms quality_terms(const BondIndices& indices, const Layout& layout)
{
    QualityTerms t;
    const double share = 1.0 / layout.beam;
    double area = 0.0, extents = 0.0;
    for (int b = 0; b < layout.beam; ++b) {
        const Block& unit = layout.blocks[b];
        const double width = unit.x1 - unit.x0, height = unit.z1 - unit.z0;
        area += area_of(unit);
        extents += width * height;
        const double size = std::max(width, height);
        if (size > kLong + kSlack)
            t.long_stones += share;
        else if (size > kMiddle - kSlack)
            t.middle_stones += share;
    }
    t.filled = area / extents;
    t.dimensions = dimensions_of(t);
    t.staggered = staggering_of(indices.trace_ratio);
    return t;
}

} // namespace dem
