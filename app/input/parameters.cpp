#include "app/input/parameters.hpp"

#include <cstddef>

namespace app {
namespace {

/// The value of one level, from a list with one value for all levels or one for each.
double at_level(const std::vector<double>& values, int level)
{
    return values.size() == 1 ? values.front() : values.at(level);
}

dem::JointParameters joint_parameters(const Parameters& p, double course_height, int level)
{
    const JointInput& joint = p.joint;
    const double kn =
        joint.wall_modulus.empty()
            ? at_level(joint.normal_stiffness, level)
            : dem::joint_stiffness(course_height, at_level(joint.wall_modulus, level),
                                   p.stone.young_modulus);
    return {kn,
            at_level(joint.shear_stiffness, level),
            joint.stiffness_factor,
            joint.friction_angle,
            joint.tensile_strength,
            joint.cohesion,
            joint.fracture_energy,
            joint.crushing,
            joint.residual_friction_angle,
            joint.wear_length};
}

} // namespace

dem::JointMaterial joint_material(const Parameters& p, double course_height, int level)
{
    return dem::joint_material(joint_parameters(p, course_height, level));
}

dem::CrackMaterial crack_material(const Parameters& p, double course_height, int level,
                                  double own)
{
    if (own > 0.0) return dem::crack_material(p.unit, own * p.stone.young_modulus);
    return dem::crack_material(p.unit, joint_parameters(p, course_height, level).kn,
                               p.stone.poisson_ratio);
}

dem::WallMaterials materials(const Parameters& p, double course_height, int level,
                             double vertical_stress, const dem::Layout& layout)
{
    dem::WallMaterials all =
        dem::wall_materials({p.stone, joint_parameters(p, course_height, level), p.unit,
                             p.base_friction_angle, p.beam_friction_angle},
                            layout);
    all.vertical_stress = vertical_stress;
    return all;
}

} // namespace app
