#include "app/text/number_text.hpp"
#include "bench/machine.hpp"
#include "bench/speed/scaling_parts.hpp"
#include "bench/speed/shortest.hpp"
#include "dem/block/model.hpp"
#include "dem/solver/ensemble.hpp"
#include "scenes/paper_wall.hpp"

#include <cstddef>
#include <iostream>
#include <string>

namespace bench {

namespace {

/// Two short courses of rigid blocks, pushed by half a millimetre: as cheap as a wall can be.
scenes::Scene tiny_wall()
{
    scenes::Scene s = scenes::paper_wall(0.75);
    s.wall.courses = 2;
    s.wall.length = 0.4;
    s.loads.height = 2 * s.wall.course_height + s.beam.height;
    return s;
}

/// The part that a study keeps of a wall: its peak, as mean and number.
struct Reduced {
    double sum = 0.0;
    std::size_t n = 0;
};

} // namespace

app::Table sample_table()
{
    const scenes::Scene scene = tiny_wall();
    dem::Discretisation d = dem::discretisation_of(dem::Fidelity::rigid);
    d.contact_points = 2;
    const dem::Model model = scenes::model_of(scene, d);
    dem::PushPlan plan;
    plan.targets = {0.5e-3};
    plan.snapshot_at_peak = false;
    dem::SolverOptions options;
    options.steps_per_mm = 200;
    options.unbalance_limit = 0.0;
    app::Table t;
    t.head = {"samples", "time [s]", "walls/s", "peak memory [MB]", "mean peak force [kN]"};
    for (const std::size_t samples : {10U, 100U, 1000U, 10'000U, 100'000U}) {
        Reduced all;
        const dem::Ensemble ensemble{
            samples, [&](std::size_t i) { return scenes::table5_sample(scene, model, i); },
            [&all](std::size_t, dem::PushResult&& r) {
                all.sum += scenes::peak_force(r);
                ++all.n;
            }};
        reset_peak_memory();
        const double seconds =
            shortest(1, [&] { dem::push_ensemble(model, ensemble, plan, options); });
        t.rows.push_back({std::to_string(all.n), app::fixed(seconds, 3),
                          app::fixed(static_cast<double>(samples) / seconds, 0),
                          app::fixed(peak_memory_mb(), 1),
                          app::fixed(1e-3 * all.sum / static_cast<double>(all.n), 3)});
        std::cerr << samples << " samples\n";
    }
    return t;
}

} // namespace bench
