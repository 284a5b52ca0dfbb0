#include "app/study/pushed/pushed_wall.hpp"

#include "app/input/study/load_input.hpp"
#include "app/input/study/output_input.hpp"
#include "app/reading/points_error.hpp"

namespace app {

namespace {

/// Reason for an outcome that is a failure: what went wrong.
std::string why_failed(dem::Outcome outcome)
{
    switch (outcome) {
    case dem::Outcome::not_finite:
        return "the numbers of this run are not finite";
    case dem::Outcome::energy_astray:
        return "the energy ledger does not close at any step tried";
    default:
        return "solver.most_steps was not enough";
    }
}

/// The breaks are read at the end, the movement of the wall where the force came down or, of a
/// push that turns back, where it was farthest out. What stands at the end of a finite push is
/// read by its movement since half of its way: walls that slide at first may overturn in the
/// end.
dem::Mechanism mechanism_of(const dem::PushResult& r, double height)
{
    if (r.at_half) return dem::mechanism(dem::movement_since(*r.at_half, r.at_end), height);
    if (!r.at_farthest) return dem::mechanism(r.at_drop.value_or(r.at_end), height);
    dem::Mechanism m = dem::mechanism(r.at_end, height);
    const dem::Mechanism out = dem::mechanism(*r.at_farthest, height);
    m.rotation_share = out.rotation_share;
    m.sliding_share = out.sliding_share;
    m.turning_share = out.turning_share;
    return m;
}

} // namespace

PushedWall read_wall(const ReadingRules& rules, const LoadInput& load,
                     const OutputInput& output, int level, dem::PushResult result)
{
    PushedWall w;
    w.vertical_stress = load.vertical_stress[level];
    w.loads = loads(load, level);
    w.result = std::move(result);
    if (dem::failed(w.result.outcome)) {
        w.reading = not_read(rules, why_failed(w.result.outcome));
        return w;
    }
    const bool single = output.single_precision_curves;
    const auto kept = [single](double x) { return single ? double{static_cast<float>(x)} : x; };
    for (const dem::CurvePoint& p : w.result.curve) {
        w.displacement.push_back(kept(p.displacement));
        w.force.push_back(kept(p.force));
    }
    w.mechanism = mechanism_of(w.result, w.loads.height);
    const bool came_down = w.result.outcome == dem::Outcome::lost_equilibrium;
    w.reading = read({w.displacement, w.force, came_down}, w.mechanism, rules, w.result.settled,
                     solver_error(w));
    return w;
}

PushedWall no_wall(const ReadingRules& rules, const LoadInput& load, int level,
                   const std::string& why)
{
    PushedWall w;
    w.vertical_stress = load.vertical_stress[level];
    w.loads = loads(load, level);
    w.result.outcome = dem::Outcome::no_wall;
    w.reading = not_read(rules, "no wall can be made of the values drawn: " + why);
    return w;
}

WallSource source_of(const PushedWall& w) { return source_of(w, w.reading); }

WallSource source_of(const PushedWall& w, const WallReading& reading)
{
    return {reading,
            w.loads.height,
            w.mechanism,
            solver_error(w),
            points_error(w.result),
            w.displacement.empty() ? kNoNumber : w.displacement.back(),
            &w.result};
}

double solver_error(const PushedWall& w)
{
    const bool no_peak = dem::failed(w.result.outcome) || came_down_at_once(w);
    return no_peak ? kNoNumber : w.result.solver_error;
}

bool came_down_at_once(const PushedWall& w)
{
    return w.result.outcome == dem::Outcome::lost_equilibrium && w.displacement.size() < 2;
}

} // namespace app
