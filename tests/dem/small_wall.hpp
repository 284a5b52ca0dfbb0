#pragma once
/// A wall small enough to be pushed many times in a test: three units long, cheap blocks.

#include "bits.hpp"
#include "dem/block/discretisation.hpp"
#include "dem/solver/push.hpp"
#include "scenes/paper_wall.hpp"

namespace small_wall {

inline scenes::Scene scene(double stress_mpa = 0.75, int courses = 3)
{
    scenes::Scene s = scenes::paper_wall(stress_mpa);
    s.wall.length = 0.6;
    s.wall.courses = courses;
    s.loads.height = courses * s.wall.course_height + s.beam.height;
    return s;
}

inline dem::Model model(const scenes::Scene& s = scene())
{
    dem::Discretisation d;
    d.contact_points = 3;
    d.block_modes = 6;
    d.beam_modes = 6;
    return scenes::model_of(s, d);
}

inline dem::PushPlan to(double target)
{
    dem::PushPlan plan;
    plan.targets = {target};
    return plan;
}

inline dem::SolverOptions quick()
{
    dem::SolverOptions o;
    o.accuracy = 0.05;
    return o;
}

inline bool same(const dem::Energy& a, const dem::Energy& b)
{
    return bits::same_number(a.work, b.work) && bits::same_number(a.kinetic, b.kinetic) &&
           bits::same_number(a.elastic, b.elastic) &&
           bits::same_number(a.friction, b.friction) &&
           bits::same_number(a.fracture, b.fracture) &&
           bits::same_number(a.crushing, b.crushing) && bits::same_number(a.damping, b.damping);
}

inline bool same_forces(const dem::CurvePoint& a, const dem::CurvePoint& b)
{
    return bits::same_number(a.displacement, b.displacement) &&
           bits::same_number(a.force, b.force) &&
           bits::same_number(a.base_shear, b.base_shear) &&
           bits::same_number(a.unbalance, b.unbalance);
}

/// All points, forces and energies.
inline bool same_curve(const dem::PushResult& a, const dem::PushResult& b)
{
    bool all = a.curve.size() == b.curve.size();
    for (std::size_t i = 0; all && i < a.curve.size(); ++i)
        all = same_forces(a.curve[i], b.curve[i]) && same(a.curve[i].energy, b.curve[i].energy);
    return all;
}

inline bool same(const dem::Snapshot& a, const dem::Snapshot& b)
{
    bool all = bits::same_number(a.displacement, b.displacement) &&
               bits::same_number(a.force, b.force) && a.faces.size() == b.faces.size() &&
               a.blocks.size() == b.blocks.size();
    for (std::size_t f = 0; all && f < a.faces.size(); ++f)
        for (std::size_t c = 0; all && c < a.faces[f].contacts.size(); ++c) {
            const dem::ContactState &x = a.faces[f].contacts[c], &y = b.faces[f].contacts[c];
            all = bits::same_number(x.opening, y.opening) &&
                  bits::same_number(x.slip, y.slip) && bits::same_number(x.sigma, y.sigma) &&
                  bits::same_number(x.tau, y.tau) && bits::same_number(x.damage, y.damage) &&
                  bits::same_number(x.crushed, y.crushed);
        }
    for (std::size_t b0 = 0; all && b0 < a.blocks.size(); ++b0)
        for (std::size_t p = 0; all && p < a.blocks[b0].displacement.size(); ++p) {
            const dem::Point &x = a.blocks[b0].displacement[p],
                             &y = b.blocks[b0].displacement[p];
            all = bits::same_number(x.x, y.x) && bits::same_number(x.z, y.z);
        }
    return all;
}

/// All but the time it took.
inline bool same(const dem::PushResult& a, const dem::PushResult& b)
{
    bool all = same_curve(a, b) && a.outcome == b.outcome && a.cost.steps == b.cost.steps &&
               a.cost.contact_updates == b.cost.contact_updates && same(a.energy, b.energy) &&
               bits::same_number(a.residual, b.residual) &&
               a.step_fraction == b.step_fraction && a.step_reductions == b.step_reductions &&
               a.slow_starts == b.slow_starts && a.slowdowns == b.slowdowns &&
               a.settled == b.settled && bits::same_number(a.settlement, b.settlement) &&
               a.snap_back_contacts == b.snap_back_contacts &&
               a.softened_in_tension == b.softened_in_tension &&
               a.softened_in_shear == b.softened_in_shear && same(a.at_peak, b.at_peak) &&
               same(a.faces_at_peak, b.faces_at_peak) && same(a.at_end, b.at_end) &&
               a.snapshots.size() == b.snapshots.size();
    for (std::size_t i = 0; all && i < a.snapshots.size(); ++i)
        all = same(a.snapshots[i], b.snapshots[i]);
    return all;
}

} // namespace small_wall
