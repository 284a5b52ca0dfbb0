#include "bench/speed/pushed_walls.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/static_start.hpp"

#include <algorithm>
#include <stdexcept>

namespace bench {

namespace {

constexpr int kStartSteps = 500; // to reach full speed, as dem::Drive

} // namespace

template <class Real>
PushedWalls<Real> pushed_walls(const scenes::Scene& scene, const dem::Discretisation& d,
                               int steps)
{
    PushedWalls<Real> w{scenes::model_of(scene, d), {}, {}, {}};
    w.options.steps_per_mm = 1000;
    w.tables = dem::step_tables(w.model);
    w.state = dem::empty_lanes<Real>(w.model, w.tables);
    for (int i = 0; i < dem::lanes<Real>; ++i) {
        const dem::WallMaterials m = scenes::table5_spatial_sample(scene, w.model, i);
        dem::WallState<double> at_rest =
            dem::unloaded<double>(w.model, w.tables, {&m, 1}, w.options);
        if (!dem::solve_preload(w.tables, at_rest))
            throw std::runtime_error("no rest under vertical load");
        dem::load_lane(w.model, w.tables, m, w.options, i, w.state);
        dem::copy_to_lane(at_rest, i, w.state);
    }
    const double speed = 1e-3 / w.options.steps_per_mm;
    for (int i = 0; i < std::min(steps, kStartSteps); ++i)
        dem::step(w.tables, w.options, {Real(1.0), Real(speed * i / kStartSteps)}, w.state);
    push_on(w, steps - kStartSteps);
    return w;
}

template <class Real> void push_on(PushedWalls<Real>& w, int steps)
{
    const dem::StepInput<Real> in{Real(1.0), Real(1e-3 / w.options.steps_per_mm)};
    for (int i = 0; i < steps; ++i) dem::step(w.tables, w.options, in, w.state);
}

template PushedWalls<double> pushed_walls(const scenes::Scene&, const dem::Discretisation&,
                                          int);
template PushedWalls<dem::Pack> pushed_walls(const scenes::Scene&, const dem::Discretisation&,
                                             int);
template void push_on(PushedWalls<double>&, int);
template void push_on(PushedWalls<dem::Pack>&, int);

} // namespace bench
