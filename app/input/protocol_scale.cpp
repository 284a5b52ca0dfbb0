#include "app/input/protocol_scale.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/keys/push_end.hpp"
#include "app/text/number_text.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/push.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace app {
namespace {

/// The same wall, pushed one way until its limits are known.
Study one_way_study(Study s)
{
    s.load.protocol = dem::Protocol::none;
    s.load.stop_below = 0.0;
    derive_stop_below(s);
    s.output.paraview = false;
    return s;
}

fragility::LimitDisplacement ultimate_of_mean_wall(const Study& s, const dem::Model& model,
                                                   int level)
{
    const dem::WallMaterials w = materials(s.parameters, s.wall.course_height,
                                           stress_level(s.load, level), model.layout);
    const dem::PushResult r = dem::push(model, w, push_plan(s), s.solver);
    if (dem::failed(r.outcome))
        throw error_at(s.source, "load.protocol_scale",
                       "the push that finds the scale failed; write protocol_scale = given");
    std::vector<double> displacement, force;
    for (const dem::CurvePoint& p : r.curve) {
        displacement.push_back(p.displacement);
        force.push_back(p.force);
    }
    const bool came_down = r.outcome == dem::Outcome::lost_equilibrium;
    return read({displacement, force, came_down}, {}, reading_rules(s)).ultimate;
}

} // namespace

void scale_protocol(PreparedStudy& ready)
{
    Study& study = ready.study;
    const LoadInput& load = study.load;
    const bool followed =
        load.protocol != dem::Protocol::none && load.targets.empty() && load.amplitudes.empty();
    if (!load.scale_one_way || !followed) return;
    const Study s = one_way_study(study);
    const dem::Model model = model_of({s, ready.layout});
    double largest = 0.0; // [m]
    for (int level = 0; level < static_cast<int>(s.load.vertical_stress.size()); ++level) {
        const auto ultimate = ultimate_of_mean_wall(s, model, level);
        const bool seen = is_observed(ultimate);
        const double at = seen ? ultimate.displacement : s.load.max_displacement;
        largest = std::max(largest, at);
        study.load.scaled += (level > 0 ? ", " : "") + std::string(seen ? "" : "> ") +
                             fixed(at * 1e3, 2) + " mm under " +
                             number(s.load.vertical_stress[level] * 1e-6, 6) + " MPa";
    }
    study.load.max_displacement = std::round(largest * 1e5) * 1e-5;
}

} // namespace app
