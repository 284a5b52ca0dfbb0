#include "app/study/pushed_wall.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/reading/wall_words.hpp"

#include <limits>

namespace app {

PushedWall read_wall(const Study& study, int level, dem::PushResult result)
{
    const ReadingRules rules = reading_rules(study);
    PushedWall w;
    w.vertical_stress = study.load.vertical_stress[static_cast<std::size_t>(level)];
    w.loads = loads(study, level);
    w.result = std::move(result);
    if (dem::failed(w.result.outcome)) {
        w.reading = not_read(rules, std::string(why_failed(w.result.outcome)));
        return w;
    }
    const bool single = study.output.single_precision_curves;
    const auto kept = [single](double x) { return single ? double{static_cast<float>(x)} : x; };
    for (const dem::CurvePoint& p : w.result.curve) {
        w.displacement.push_back(kept(p.displacement));
        w.force.push_back(kept(p.force));
    }
    w.mechanism = dem::mechanism(w.result.at_drop.value_or(w.result.at_end), w.loads.height);
    const bool came_down = w.result.outcome == dem::Outcome::lost_equilibrium;
    w.reading = read({w.displacement, w.force, came_down}, w.mechanism, rules);
    return w;
}

PushedWall no_wall(const Study& study, int level, const std::string& why)
{
    PushedWall w;
    w.vertical_stress = study.load.vertical_stress[static_cast<std::size_t>(level)];
    w.loads = loads(study, level);
    w.result.outcome = dem::Outcome::no_wall;
    w.reading = not_read(reading_rules(study), "the values drawn make no wall: " + why);
    return w;
}

double energy_residual(const PushedWall& w)
{
    return w.result.outcome == dem::Outcome::not_finite
               ? std::numeric_limits<double>::quiet_NaN()
               : w.result.residual;
}

} // namespace app
