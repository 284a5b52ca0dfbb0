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

JointMaterial joint_material(const JointParameters& j)
{
    return {j.stiffness_factor * j.kn,
            j.stiffness_factor * j.ks,
            std::tan(j.friction_angle),
            j.tensile_strength,
            j.cohesion,
            j.fracture_energy};
}

CrackMaterial crack_material(const CrackParameters& c, double joint_kn, double poisson_ratio)
{
    const double kn = c.stiffness_factor * c.stiffness_ratio * joint_kn;
    const double ft =
        c.snap_back == SnapBack::weakens
            ? std::min(c.tensile_strength, std::sqrt(2.0 * c.fracture_energy * kn))
            : c.tensile_strength;
    return {.kn = kn,
            .ks = shear_stiffness(kn, poisson_ratio),
            .ft = ft,
            .cohesion = c.cohesion,
            .cohesion_res = std::min(c.residual_cohesion, c.cohesion),
            .tan_phi = std::tan(c.friction_angle),
            .tan_phi_res = std::tan(std::min(c.residual_friction_angle, c.friction_angle)),
            .fracture_energy = c.fracture_energy,
            .tension_reduces_shear = c.tension_reduces_shear};
}

WallMaterials wall_materials(const PaperMaterials& p, int n_joints, int n_cracks)
{
    const CrackMaterial crack = crack_material(p.crack, p.joint.kn, p.stone.poisson_ratio);
    WallMaterials w;
    w.stone = p.stone;
    w.joints.assign(static_cast<std::size_t>(n_joints), joint_material(p.joint));
    w.cracks.assign(static_cast<std::size_t>(n_cracks), crack);
    w.base_joint = {p.joint.kn, p.joint.ks, std::tan(p.base_friction_angle)};
    w.beam_joint = {p.joint.kn, p.joint.ks, std::tan(p.beam_friction_angle)};
    return w;
}

} // namespace dem
