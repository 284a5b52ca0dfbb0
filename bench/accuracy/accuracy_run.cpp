#include "bench/accuracy/accuracy_run.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/prepared_study.hpp"
#include "app/sampling/wall_draw.hpp"
#include "app/study/pushed/pushed_wall.hpp"
#include "app/text/number_text.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/slower.hpp"
#include "dem/solver/step/vertical_load.hpp"
#include "dem/solver/thread_time.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

namespace bench {

namespace {

struct TooDear : std::exception {};

/// Ends the push with TooDear.
dem::PushPlan limited(dem::PushPlan plan, double most_seconds)
{
    const double end = dem::thread_seconds() + most_seconds;
    plan.progress = [end](const dem::PushProgress&) {
        if (dem::thread_seconds() > end) throw TooDear();
    };
    return plan;
}

Answer read_answer(const app::PushedWall& wall)
{
    Answer a;
    const dem::PushResult& r = wall.result;
    a.outcome = app::came_down_at_once(wall) ? "came down at once" : name(r.outcome);
    a.solver_error = r.solver_error;
    a.residual = r.residual;
    a.steps = r.cost.steps;
    if (const auto& peak = wall.reading.peak; peak && peak->force > 0.0) {
        a.peak = peak->force;
        a.peak_at = peak->displacement;
        const auto fall = [](const fragility::LimitDisplacement& d) {
            return is_observed(d) ? std::optional(d.displacement) : std::nullopt;
        };
        a.drop = fall(wall.reading.ultimate);
        a.earliest = fall(wall.reading.ultimate_range.earliest);
        a.latest = fall(wall.reading.ultimate_range.latest);
    }
    return a;
}

} // namespace

std::string speed_settings(const dem::SolverOptions& o)
{
    return app::number(o.steps_per_mm, 6) + "/mm unbalance " +
           app::number(o.unbalance_limit, 6) + " accuracy " + app::number(o.accuracy, 6);
}

dem::SolverOptions reference_options(const app::Study& asked, const app::Study& as_drawn)
{
    dem::SolverOptions o = asked.solver;
    const dem::SolverOptions& own = as_drawn.solver;
    o.accuracy = own.accuracy;
    o.steps_per_mm = own.steps_per_mm;
    o.unbalance_limit = own.unbalance_limit;
    o.min_speed = own.min_speed;
    o.most_steps = std::numeric_limits<long long>::max() / 1000;
    return dem::slower(o, kReferenceFactor);
}

Answer push_answer(const app::Study& study, const dem::SolverOptions& options,
                   double most_seconds)
{
    const double start = dem::thread_seconds();
    const dem::Model model = app::model_of(app::prepare(study));
    const dem::WallMaterials materials = app::wall_materials(
        study, study.random, app::stress_level(study.load, 0), model.layout, {});
    Answer a;
    try {
        dem::PushResult result =
            dem::push(model, materials, limited(app::push_plan(study), most_seconds), options);
        a = read_answer(app::read_wall(app::reading_rules(study), study.load, study.output, 0,
                                       std::move(result)));
    } catch (const TooDear&) {
        a.outcome = kTooDear;
    }
    a.seconds = dem::thread_seconds() - start;
    return a;
}

WallFacts facts_of(const app::Study& study)
{
    const dem::Model model = app::model_of(app::prepare(study));
    const dem::WallMaterials w = app::wall_materials(
        study, study.random, app::stress_level(study.load, 0), model.layout, {});
    return {w.base_joint.kn, dem::vertical_load(model, w)};
}

} // namespace bench
