#include "app/study/pushed_wall.hpp"

#include "dem/block/model.hpp"

#include <cmath>

namespace app {

namespace {

const char* why_failed(dem::Outcome o)
{
    if (o == dem::Outcome::not_finite) return "the numbers of this run are not finite";
    if (o == dem::Outcome::energy_astray)
        return "the energy ledger does not close at any step tried";
    return "solver.most_steps were not enough";
}

bool is_monotonic(const dem::PushPlan& plan)
{
    double from = 0.0;
    for (const double to : plan.targets) {
        if (to < from) return false;
        from = to;
    }
    return true;
}

void read_curve(PushedWall& w)
{
    const fragility::Curve curve{w.displacement, w.force};
    w.peak = fragility::peak(curve);
    w.stiffness = fragility::secant_stiffness(curve);
    w.ultimate = fragility::drop_after_peak(curve);
    for (const auto set : {fragility::LimitStateSet::paper, fragility::LimitStateSet::ntc,
                           fragility::LimitStateSet::ec8})
        for (const fragility::LimitState& s : fragility::read_limit_states(curve, set))
            w.limit_states.push_back(s);
}

} // namespace

PushedWall read_wall(const Study& study, int level, dem::PushResult result)
{
    PushedWall w;
    w.vertical_stress = study.load.vertical_stress[static_cast<std::size_t>(level)];
    w.loads = loads(study, level);
    w.result = std::move(result);
    if (dem::failed(w.result.outcome)) {
        w.no_reading = why_failed(w.result.outcome);
        return w;
    }
    for (const dem::CurvePoint& p : w.result.curve) {
        w.displacement.push_back(p.displacement);
        w.force.push_back(p.force);
    }
    w.mechanism = dem::mechanism(w.result.at_end, w.loads.height);
    if (w.displacement.size() < 2)
        w.no_reading = "the wall came down under vertical load";
    else if (is_monotonic(push_plan(study)))
        read_curve(w);
    else
        w.no_reading = "the push turns back: limit states are read off a monotonic push";
    const bool dropped = w.peak && w.ultimate.reading == fragility::Reading::observed;
    w.mode = dem::failure_mode(w.mechanism, dropped);
    return w;
}

PushedWall no_wall(const Study& study, int level, const std::string& why)
{
    PushedWall w;
    w.vertical_stress = study.load.vertical_stress[static_cast<std::size_t>(level)];
    w.loads = loads(study, level);
    w.result.outcome = dem::Outcome::no_wall;
    w.no_reading = "the values drawn make no wall: " + why;
    return w;
}

} // namespace app
