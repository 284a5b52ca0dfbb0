#include "dem/scene/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace dem {

namespace {

bool is_bed(FaceKind k)
{
    return k == FaceKind::bed_joint || k == FaceKind::base_joint || k == FaceKind::beam_joint;
}

/// Rotation of the loading beam, from the vertical displacements of its ends [-].
double beam_rotation(const Snapshot& wall)
{
    const BlockState& beam = wall.blocks.back();
    const auto [left, right] = std::minmax_element(beam.outline.begin(), beam.outline.end(),
                                                   [](Point a, Point b) { return a.x < b.x; });
    const auto l = left - beam.outline.begin(), r = right - beam.outline.begin();
    return (beam.displacement[l].z - beam.displacement[r].z) / (right->x - left->x);
}

/// Mean slip of the contacts that are closed, summed over the bed joints [m].
double sliding(const Snapshot& wall)
{
    struct Sum {
        double slip = 0.0, area = 0.0;
    };
    std::map<int, Sum> by_course; // below the joint
    for (const FaceState& f : wall.faces)
        if (is_bed(f.kind)) {
            const int course = f.block_a < 0 ? 0 : wall.blocks[f.block_a].course;
            for (const ContactState& c : f.contacts)
                if (c.sigma < 0.0) {
                    Sum& sum = by_course[course];
                    sum.slip += c.slip * c.area;
                    sum.area += c.area;
                }
        }
    double total = 0.0;
    for (const auto& [course, sum] : by_course) total += sum.slip / sum.area;
    return total;
}

} // namespace

Mechanism mechanism(const Snapshot& wall, double height)
{
    Mechanism m;
    if (wall.displacement != 0.0) {
        m.rotation_share = beam_rotation(wall) * height / wall.displacement;
        m.sliding_share = sliding(wall) / wall.displacement;
    }
    for (const FaceState& f : wall.faces) {
        if (f.kind != FaceKind::unit_crack) continue;
        const auto broken =
            std::count_if(f.contacts.begin(), f.contacts.end(),
                          [](const ContactState& c) { return c.damage >= 1.0; });
        m.cracked_contacts += static_cast<int>(broken);
        m.cracked_units += broken == static_cast<std::ptrdiff_t>(f.contacts.size());
    }
    return m;
}

FailureMode failure_mode(const Mechanism& m, bool load_dropped, const ModeThresholds& t)
{
    const bool cracked = m.cracked_units >= t.cracked_units;
    const bool overturns = m.rotation_share >= t.rotation_share;
    if (t.modes == ModeRule::three) {
        if (cracked && (load_dropped || !overturns)) return FailureMode::mixed;
        return overturns ? FailureMode::rocking : FailureMode::sliding;
    }
    return load_dropped || (cracked && !overturns) ? FailureMode::mixed : FailureMode::rocking;
}

} // namespace dem
