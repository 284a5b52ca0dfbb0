#include "bench/stability/stress_limit.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/finite_step.hpp"
#include "dem/solver/step/stability_limit.hpp"
#include "dem/solver/step/step.hpp"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

/// Joints that are as stiff as those that turn, at the same closure.
dem::ClosureLaw<double> turning(dem::ClosureLaw<double> law)
{
    const double stiffer = law.turning;
    for (double* x : {&law.k0, &law.rise, &law.stiffest, &law.knee_pressure}) *x *= stiffer;
    law.inv_rise /= stiffer;
    return law;
}

double measured(const dem::StepTables& t, dem::WallState<double> s,
                const dem::SolverOptions& options)
{
    for (auto& law : s.laws.closing) law = turning(law);
    return dem::step_over_limit(t, s, options);
}

} // namespace

double over_limit_on_the_way(const StressScene& scene, const dem::Model& model, int wall)
{
    constexpr int kLooks = 6, kSteps = 250; // between them
    const dem::SolverOptions& options = scene.solver;
    const dem::WallMaterials materials = stress_wall(scene, model, wall);
    const dem::StepTables t = dem::step_tables(model);
    auto s = dem::unloaded<double>(model, t, {&materials, 1}, options);
    if (!dem::solve_preload(t, s)) return 0.0;
    if (options.kinematics == dem::Kinematics::finite) dem::take_up_frames(t, options, s);
    double worst = measured(t, s, options);
    for (int look = 0; look < kLooks; ++look) {
        const double drive = (look < kLooks / 2 ? 1e-3 : -1e-3) / options.steps_per_mm;
        for (int i = 0; i < kSteps; ++i) dem::step<double>(t, options, {1.0, drive, 1.0}, s);
        if (!std::isfinite(s.top_force)) break;
        worst = std::max(worst, measured(t, s, options));
    }
    return worst;
}

} // namespace bench
