#include "app/input/study/parameters.hpp"

#include <algorithm>
#include <cstddef>

namespace app {
namespace {

/// The value of one level, from a list with one value for all levels or one for each.
double at_level(const std::vector<double>& values, int level)
{
    return values.size() == 1 ? values.front() : values.at(level);
}

double normal_stiffness(const Parameters& p, double course_height, StressLevel level)
{
    const JointInput& joint = p.joint;
    if (closes(joint)) return dem::closed_stiffness(joint.closing, level.stress);
    if (joint.wall_modulus.empty()) return at_level(joint.normal_stiffness, level.index);
    return dem::joint_stiffness(course_height, at_level(joint.wall_modulus, level.index),
                                p.stone.young_modulus);
}

/// A draw may begin stiffer than the end that is given for all, or far softer.
dem::Closing closing_of(const JointInput& joint)
{
    if (!closes(joint)) return {};
    dem::Closing c = joint.closing;
    c.stiffest =
        std::clamp(c.stiffest, c.initial_stiffness, dem::kMostStiffening * c.initial_stiffness);
    return c;
}

dem::JointParameters joint_parameters(const Parameters& p, double course_height,
                                      StressLevel level)
{
    const JointInput& joint = p.joint;
    const double kn = normal_stiffness(p, course_height, level);
    const bool bonded = joint.tensile_strength > 0.0 || joint.cohesion > 0.0;
    return {kn,
            joint.shear_stiffness.empty() ? dem::shear_stiffness(kn, p.stone.poisson_ratio)
                                          : at_level(joint.shear_stiffness, level.index),
            joint.stiffness_factor,
            joint.friction_angle,
            joint.tensile_strength,
            joint.cohesion,
            joint.fracture_energy,
            joint.crushing,
            joint.residual_friction_angle,
            joint.wear_length,
            closing_of(joint),
            bonded ? joint.envelope : dem::Envelope::coulomb,
            bonded ? joint.shear_fracture_energy : 0.0};
}

} // namespace

dem::ClosureFit closure_fit(const Parameters& p, double course_height)
{
    std::vector<double> stiffness;
    for (const double modulus : p.joint.wall_modulus)
        stiffness.push_back(
            dem::joint_stiffness(course_height, modulus, p.stone.young_modulus));
    return dem::fit_closure(stiffness, p.joint.modulus_stress);
}

dem::JointMaterial joint_material(const Parameters& p, double course_height, StressLevel level)
{
    return dem::joint_material(joint_parameters(p, course_height, level));
}

dem::CrackMaterial crack_material(const Parameters& p, double course_height, StressLevel level,
                                  double own)
{
    if (own > 0.0) return dem::crack_material(p.unit, own * p.stone.young_modulus);
    return dem::crack_material(p.unit, joint_parameters(p, course_height, level).kn,
                               p.stone.poisson_ratio);
}

dem::WallMaterials materials(const Parameters& p, double course_height, StressLevel level,
                             const dem::Layout& layout)
{
    dem::WallMaterials all =
        dem::wall_materials({p.stone, joint_parameters(p, course_height, level), p.unit,
                             p.base_friction_angle, p.beam_friction_angle},
                            layout);
    all.vertical_stress = level.stress;
    return all;
}

} // namespace app
