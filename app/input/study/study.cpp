#include "app/input/study/study.hpp"

#include "dem/solver/stop_rules.hpp"
#include "fragility/curve/cyclic_curve.hpp"

#include <algorithm>
#include <cstddef>

namespace app {
namespace {

/// True once the forces of a whole cycle are below a share of the largest so far, on both
/// sides.
dem::StopRule stop_both_below(double share)
{
    return [share](std::span<const dem::CurvePoint> curve) {
        const std::size_t n = curve.size(); // cycles end where the path passes zero
        if (n < 2 || curve[n - 1].displacement * curve[n - 2].displacement > 0.0) return false;
        std::vector<double> displacement, force;
        for (const dem::CurvePoint& p : curve) {
            displacement.push_back(p.displacement);
            force.push_back(p.force);
        }
        // The first points beyond zero are no visit of the other side.
        displacement.back() = 0.0;
        double plus = 0.0, minus = 0.0;
        bool weak = false;
        for (const fragility::Cycle& c : fragility::cycles({displacement, force})) {
            plus = std::max(plus, c.force_plus);
            minus = std::min(minus, c.force_minus);
            // After half a cycle the wall has not been on the other side.
            weak =
                (plus == 0.0 || (c.displacement_plus > 0.0 && c.force_plus < share * plus)) &&
                (minus == 0.0 || (c.displacement_minus < 0.0 && c.force_minus > share * minus));
        }
        return weak;
    };
}

} // namespace

dem::PushPlan push_plan(const Study& study)
{
    dem::PushPlan plan;
    plan.targets = push_targets(study.load);
    plan.record_every = study.output.record_every;
    plan.snapshot_every = study.output.paraview ? study.output.snapshot_every : 0.0;
    const bool finite = study.solver.kinematics == dem::Kinematics::finite;
    const int direction = push_way(study.load).direction;
    const bool to_and_fro = direction == 0;
    if (finite && !to_and_fro) plan.drop = study.fragility.ultimate_share;
    if (study.load.stop_below > 0.0)
        plan.decided = to_and_fro ? stop_both_below(study.load.stop_below)
                                  : dem::stop_below(study.load.stop_below, direction);
    else if (finite && !to_and_fro)
        plan.decided = dem::at_zero_force(direction);
    return plan;
}

Study turned_round(Study study)
{
    Direction& d = study.load.direction;
    d = d == Direction::left ? Direction::right : Direction::left;
    study.wall.toe_at_left = push_way(study.load).direction < 0;
    return study;
}

} // namespace app
