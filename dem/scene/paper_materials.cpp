#include "dem/scene/paper_materials.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

double joint_stiffness(double h, double wall_modulus, double stone_modulus)
{
    return 1.0 / (h * (1.0 / wall_modulus - 1.0 / stone_modulus));
}

double shear_stiffness(double kn, double poisson_ratio)
{
    return kn / (2.0 * (1.0 + poisson_ratio));
}

namespace {

Wear wear_of(const JointParameters& j, double friction_angle)
{
    if (j.wear_length == 0.0) return {};
    return {std::tan(std::min(j.residual_friction_angle, friction_angle)), j.wear_length};
}

/// A factor on the stiffness of a joint makes it close by so much less under the same pressure.
Closing closing_of(const JointParameters& j)
{
    Closing c = j.closing;
    c.initial_stiffness *= j.stiffness_factor;
    c.maximum /= j.stiffness_factor;
    c.stiffest *= j.stiffness_factor;
    return c;
}

} // namespace

JointMaterial joint_material(const JointParameters& j)
{
    return {j.stiffness_factor * j.kn,
            j.stiffness_factor * j.ks,
            std::tan(j.friction_angle),
            j.tensile_strength,
            j.cohesion,
            j.fracture_energy,
            j.crushing,
            wear_of(j, j.friction_angle),
            closing_of(j),
            j.envelope,
            j.shear_fracture_energy};
}

namespace {

CrackMaterial of_stiffness(const CrackParameters& c, double kn, double ks)
{
    const double ft =
        c.snap_back == SnapBack::weakens
            ? std::min(c.tensile_strength, std::sqrt(2.0 * c.fracture_energy * kn))
            : c.tensile_strength;
    return {.kn = kn,
            .ks = ks,
            .ft = ft,
            .cohesion = c.cohesion,
            .cohesion_res = std::min(c.residual_cohesion, c.cohesion),
            .tan_phi = std::tan(c.friction_angle),
            .tan_phi_res = std::tan(std::min(c.residual_friction_angle, c.friction_angle)),
            .fracture_energy = c.fracture_energy,
            .tension_reduces_shear = c.tension_reduces_shear,
            .crushing = c.crushing,
            .envelope = c.envelope,
            .shear_fracture_energy = c.shear_fracture_energy};
}

} // namespace

CrackMaterial crack_material(const CrackParameters& c, double joint_kn, double poisson_ratio)
{
    const double kn = c.stiffness_factor * c.stiffness_ratio * joint_kn;
    return of_stiffness(c, kn, shear_stiffness(kn, poisson_ratio));
}

CrackMaterial crack_material(const CrackParameters& c, double stiffness)
{
    return of_stiffness(c, c.stiffness_factor * stiffness, c.stiffness_factor * stiffness);
}

WallMaterials wall_materials(const PaperMaterials& p, const Layout& layout)
{
    const CrackMaterial crack = crack_material(p.crack, p.joint.kn, p.stone.poisson_ratio);
    WallMaterials w;
    w.stone = p.stone;
    w.joints.assign(static_cast<std::size_t>(layout.n_joints), joint_material(p.joint));
    w.cracks.assign(static_cast<std::size_t>(layout.n_cracks), crack);
    for (std::size_t k = 0; k < layout.crack_stiffness.size(); ++k)
        if (const double own = layout.crack_stiffness[k]; own > 0.0)
            w.cracks[k] = crack_material(p.crack, own * p.stone.young_modulus);
    w.base_joint = {.kn = p.joint.kn,
                    .ks = p.joint.ks,
                    .tan_phi = std::tan(p.base_friction_angle),
                    .crushing = p.joint.crushing,
                    .wear = wear_of(p.joint, p.base_friction_angle),
                    .closing = p.joint.closing};
    w.beam_joint = w.base_joint;
    w.beam_joint.tan_phi = std::tan(p.beam_friction_angle);
    w.beam_joint.wear = wear_of(p.joint, p.beam_friction_angle);
    return w;
}

} // namespace dem
