#include "dem/solver/push.hpp"

#include "dem/solver/batch.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace dem {

namespace {

void require(bool ok, const char* what)
{
    if (!ok) throw std::invalid_argument(what);
}

} // namespace

void check(const Model& m, const WallMaterials& w)
{
    require(static_cast<int>(w.joints.size()) == m.layout.n_joints,
            "one material per joint ID");
    require(static_cast<int>(w.cracks.size()) == m.layout.n_cracks,
            "one material per crack ID");
    require(w.vertical_stress.value_or(0.0) >= 0, "vertical stress must not be negative");
    for (const JointMaterial& j : w.joints)
        require(j.kn > 0 && j.ks > 0 && j.tan_phi >= 0,
                "a joint needs positive stiffness and friction >= 0");
    for (const CrackMaterial& c : w.cracks)
        require(
            c.kn > 0 && c.ks > 0 && c.ft >= 0 && c.cohesion >= c.cohesion_res &&
                c.cohesion_res >= 0 && c.tan_phi >= 0 && c.tan_phi_res >= 0 &&
                c.fracture_energy >= 0,
            "a unit crack needs positive stiffness and strengths >= 0, residual <= initial");
}

void check(const PushPlan& plan, const SolverOptions& o)
{
    for (const double target : plan.targets)
        require(std::isfinite(target), "targets must be finite");
    require(plan.record_every > 0 && plan.snapshot_every >= 0,
            "curve points need a spacing > 0");
    require(o.steps_per_mm > 0 && o.damping_factor >= 0 && o.damping_factor < 1 &&
                o.step_fraction > 0 && o.energy_tolerance > 0,
            "steps per mm > 0, damping factor in [0, 1), step fraction > 0, tolerance > 0");
}

PushResult push(const Model& model, const WallMaterials& materials, const PushPlan& plan,
                const SolverOptions& options)
{
    check(model, materials);
    check(plan, options);
    const StepTables tables = step_tables(model);
    PushResult result;
    bool waiting = true;
    run_batch<double>(
        {model, tables, plan, options}, 1,
        [&]() -> std::optional<NumberedWall> {
            if (!std::exchange(waiting, false)) return {};
            return NumberedWall{0, materials};
        },
        [&](std::size_t, PushResult&& r) { result = std::move(r); });
    return result;
}

} // namespace dem
