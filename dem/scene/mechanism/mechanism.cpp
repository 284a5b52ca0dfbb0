#include "dem/scene/mechanism/mechanism.hpp"

#include "dem/scene/geometry/polygon.hpp"
#include "dem/scene/mechanism/rotation_share.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace dem {

namespace {

/// Share of the displacement that rotation to the side of the push and slip of bed joints make
/// up together; below it, rotations to either side count. The majority, a free choice.
constexpr double kSeen = 0.5;

bool is_bed(FaceKind k)
{
    return k == FaceKind::bed_joint || k == FaceKind::base_joint || k == FaceKind::beam_joint;
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

int broken_contacts(const FaceState& f)
{
    return static_cast<int>(
        std::count_if(f.contacts.begin(), f.contacts.end(),
                      [](const ContactState& c) { return c.damage >= 1.0; }));
}

/// Joins the blocks that a crack still holds together: each block to the first of its part.
std::vector<int> held_together(const Snapshot& wall)
{
    std::vector<int> first(wall.blocks.size());
    std::iota(first.begin(), first.end(), 0);
    const auto root = [&](int b) {
        while (first[b] != b) b = first[b] = first[first[b]];
        return b;
    };
    for (const FaceState& f : wall.faces) {
        if (f.kind != FaceKind::unit_crack) continue;
        if (f.contacts.empty() || is_cracked_through(f)) continue;
        const int a = root(f.block_a), b = root(f.block_b);
        first[std::max(a, b)] = std::min(a, b);
    }
    for (int b = 0; b < static_cast<int>(first.size()); ++b) first[b] = root(b);
    return first;
}

void count_broken_units(const Snapshot& wall, Mechanism& m)
{
    struct Unit {
        double area = 0.0;
        std::map<int, double> parts; ///< area by first block
    };
    const std::vector<int> part = held_together(wall);
    std::map<int, Unit> units;
    for (std::size_t b = 0; b < wall.blocks.size(); ++b) {
        const double area = polygon_area(wall.blocks[b].outline);
        Unit& unit = units[wall.blocks[b].unit];
        unit.area += area;
        unit.parts[part[b]] += area;
    }
    for (const auto& [number, unit] : units) {
        if (unit.parts.size() < 2) continue;
        double largest = 0.0;
        for (const auto& [first, area] : unit.parts) largest = std::max(largest, area);
        (largest <= kLargestPart * unit.area ? m.cracked_units : m.spalled_units) += 1;
    }
}

} // namespace

Mechanism mechanism(const Snapshot& wall, double height)
{
    Mechanism m;
    if (wall.displacement != 0.0) {
        m.turning_share = turning_share(wall, height);
        m.rotation_share = beam_rotation_share(wall, height).value_or(m.turning_share);
        m.sliding_share = sliding(wall) / wall.displacement;
        const double seen =
            std::max(m.rotation_share, m.turning_share) + std::abs(m.sliding_share);
        if (seen < kSeen) m.turning_share = turning_share(wall, height, Turns::to_either_side);
    }
    for (const FaceState& f : wall.faces) {
        if (f.kind == FaceKind::unit_crack) m.cracked_contacts += broken_contacts(f);
        for (const ContactState& c : f.contacts) {
            m.crushed_contacts += c.crushed > 0.0;
            m.crushed_area += c.crushing >= 1.0 ? c.area : 0.0;
        }
    }
    count_broken_units(wall, m);
    return m;
}

Snapshot movement_since(const Snapshot& from, Snapshot to)
{
    to.displacement -= from.displacement;
    for (std::size_t b = 0; b < to.blocks.size(); ++b)
        for (std::size_t p = 0; p < to.blocks[b].displacement.size(); ++p) {
            to.blocks[b].displacement[p].x -= from.blocks[b].displacement[p].x;
            to.blocks[b].displacement[p].z -= from.blocks[b].displacement[p].z;
        }
    for (std::size_t f = 0; f < to.faces.size(); ++f)
        for (std::size_t c = 0; c < to.faces[f].contacts.size(); ++c)
            to.faces[f].contacts[c].slip -= from.faces[f].contacts[c].slip;
    return to;
}

bool rocks(const Mechanism& m, const ModeThresholds& t)
{
    return std::max(m.rotation_share, m.turning_share) >= t.rotation_share;
}

FailureMode failure_mode(const Mechanism& m, bool load_dropped, const ModeThresholds& t)
{
    const bool cracked = m.cracked_units >= t.cracked_units;
    const bool overturns = m.rotation_share >= t.rotation_share;
    if (t.modes == ModeRule::mechanism) {
        if (overturns) return FailureMode::rocking;
        if (cracked) return FailureMode::mixed;
        return rocks(m, t) ? FailureMode::rocking : FailureMode::sliding;
    }
    return load_dropped || (cracked && !overturns) ? FailureMode::mixed : FailureMode::rocking;
}

} // namespace dem
