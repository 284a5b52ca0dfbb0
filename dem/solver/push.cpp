#include "dem/solver/push.hpp"

#include "dem/block/model.hpp"
#include "dem/scene/closure_fit.hpp"
#include "dem/solver/batch.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace dem {

namespace {

void require(bool ok, const std::string& what)
{
    if (!ok) throw std::invalid_argument(what);
}

/// @param name of the joint, as the message begins
void check_joint(const std::string& name, const JointMaterial& j)
{
    require(j.kn > 0 && j.ks > 0, name + ": normal and shear stiffness must be positive");
    require(j.tan_phi >= 0, name + ": the friction coefficient must not be negative");
    require(j.ft >= 0 && j.cohesion >= 0 && j.fracture_energy >= 0,
            name + ": strengths and fracture energy must not be negative");
}

void check_wear(const Model& m, const std::string& name, const JointMaterial& j)
{
    const Wear& w = j.wear;
    require(w.length >= 0, name + ": the wear length must not be negative");
    if (w.length == 0.0) return;
    require(w.tan_phi_res >= 0 && w.tan_phi_res <= j.tan_phi,
            name +
                ": the friction coefficient of the worn joint must lie between 0 and that of "
                "the new one");
    require(m.layout.wear && !m.layout.mortar,
            name + ": wear needs a layout with wear and without mortar");
}

void check_closing(const Model& m, const std::string& name, const JointMaterial& j)
{
    if (m.layout.closure == Closure::linear) return;
    const Closing& c = j.closing;
    require(!m.layout.mortar, name + ": joints with mortar do not close further");
    require(c.initial_stiffness > 0 && c.maximum > 0,
            name + ": initial stiffness and maximum closure must be positive");
    require(c.loss >= 0 && c.loss < 1, name + ": the closure loss must lie in [0, 1)");
    require(c.stiffest >= c.initial_stiffness &&
                c.stiffest <= kMostStiffening * c.initial_stiffness,
            name +
                ": the largest stiffness must lie between the initial one and 1000 times that");
}

void check_crushing(const Model& m, const std::string& name, const Crushing& c)
{
    require(c.strength >= 0 && c.energy >= 0,
            name + ": compressive strength and crushing energy must not be negative");
    require(m.layout.crushing || c.strength == 0.0,
            name + ": a compressive strength needs a layout with crushing");
}

void check_mixed_mode(const Model& m, const std::string& name, Envelope envelope,
                      double shear_fracture_energy)
{
    require(shear_fracture_energy >= 0,
            name + ": the fracture energy in shear must not be negative");
    require(m.layout.mixed_mode ||
                (envelope == Envelope::coulomb && shear_fracture_energy == 0.0),
            name + ": a hyperbolic envelope and a fracture energy in shear need a layout with "
                   "mixed modes");
}

void check_crack(const std::string& name, const CrackMaterial& c)
{
    require(c.kn > 0 && c.ks > 0, name + ": normal and shear stiffness must be positive");
    require(c.ft >= 0 && c.fracture_energy >= 0,
            name + ": tensile strength and fracture energy must not be negative");
    require(c.cohesion_res >= 0 && c.cohesion >= c.cohesion_res,
            name + ": the residual cohesion must lie between 0 and the initial cohesion");
    require(c.tan_phi >= 0 && c.tan_phi_res >= 0,
            name + ": friction coefficients must not be negative");
}

void check_stone(const Model& m, const Elastic& stone)
{
    require(stone.young_modulus > 0, "stone: Young's modulus must be positive");
    require(stone.density >= 0, "stone: the density must not be negative");
    require(stone.poisson_ratio == m.stone.poisson_ratio,
            "stone: Poisson's ratio must be that of the model, because the modes of its blocks "
            "are those of one ratio; make a model for each ratio");
}

std::string numbered(const char* what, std::size_t index)
{
    return what + (" " + std::to_string(index + 1));
}

} // namespace

void check(const Model& m, const WallMaterials& w)
{
    check_stone(m, w.stone);
    require(static_cast<int>(w.joints.size()) == m.layout.n_joints,
            "the wall needs one material for each of its " + std::to_string(m.layout.n_joints) +
                " joint IDs");
    require(static_cast<int>(w.cracks.size()) == m.layout.n_cracks,
            "the wall needs one material for each of its " + std::to_string(m.layout.n_cracks) +
                " crack IDs");
    require(w.vertical_stress.value_or(0.0) >= 0, "the vertical stress must not be negative");
    for (std::size_t i = 0; i < w.joints.size(); ++i)
        check_joint(numbered("joint", i), w.joints[i]);
    require(m.layout.mortar || std::ranges::all_of(w.joints,
                                                   [](const JointMaterial& j) {
                                                       return j.ft == 0.0 && j.cohesion == 0.0;
                                                   }),
            "joints with tensile strength or cohesion need a layout with mortar");
    for (std::size_t i = 0; i < w.cracks.size(); ++i)
        check_crack(numbered("crack", i), w.cracks[i]);
    for (std::size_t i = 0; i < w.joints.size(); ++i)
        check_mixed_mode(m, numbered("joint", i), w.joints[i].envelope,
                         w.joints[i].shear_fracture_energy);
    for (std::size_t i = 0; i < w.cracks.size(); ++i)
        check_mixed_mode(m, numbered("crack", i), w.cracks[i].envelope,
                         w.cracks[i].shear_fracture_energy);
    for (std::size_t i = 0; i < w.joints.size(); ++i)
        check_crushing(m, numbered("joint", i), w.joints[i].crushing);
    for (std::size_t i = 0; i < w.cracks.size(); ++i)
        check_crushing(m, numbered("crack", i), w.cracks[i].crushing);
    for (std::size_t i = 0; i < w.joints.size(); ++i)
        check_wear(m, numbered("joint", i), w.joints[i]);
    for (std::size_t i = 0; i < w.joints.size(); ++i)
        check_closing(m, numbered("joint", i), w.joints[i]);
    check_closing(m, "base joint", w.base_joint);
    check_closing(m, "beam joint", w.beam_joint);
    check_wear(m, "base joint", w.base_joint);
    check_wear(m, "beam joint", w.beam_joint);
    check_joint("beam joint", w.beam_joint);
    if (std::ranges::any_of(m.layout.faces, [](const Face& f) { return f.a == kGround; }))
        check_joint("base joint", w.base_joint);
}

void check(const PushPlan& plan, const SolverOptions& o)
{
    for (const double target : plan.targets)
        require(std::isfinite(target), "target displacements must be finite");
    require(plan.record_every > 0, "the spacing of curve points must be positive");
    require(plan.drop >= 0 && plan.drop < 1, "the share at the drop must lie in [0, 1)");
    require(plan.snapshot_every >= 0, "the spacing of snapshots must not be negative");
    require(!plan.sink.take || plan.sink.forget,
            "a sink that takes snapshots must forget them where a push starts anew");
    require(o.accuracy > 0 && o.accuracy <= 0.5, "the accuracy must lie in (0, 0.5]");
    require(o.steps_per_mm > 0, "steps per mm must be positive");
    require(o.damping_factor >= 0 && o.damping_factor < 1,
            "the damping factor must lie in [0, 1)");
    require(o.step_fraction > 0, "the step fraction must be positive");
    require(o.energy_tolerance > 0, "the energy tolerance must be positive");
}

void check(const Model& m, const SolverOptions& o)
{
    require(!m.layout.mixed_mode ||
                (o.law == ContactLaw::coupled && o.unloading == Unloading::secant),
            "the law of mixed modes is coupled, and unloads in tension to the origin");
}

PushResult push(const Model& model, const WallMaterials& materials, const PushPlan& plan,
                const SolverOptions& options)
{
    check(model, materials);
    check(plan, options);
    check(model, options);
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
