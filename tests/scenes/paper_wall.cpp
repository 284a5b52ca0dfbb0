#include "scenes/paper_wall.hpp"
#include "dem/block/model.hpp"

#include "dem/scene/paper_materials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace scenes {

namespace {

/// Table 3 [Pa]; 0.75 MPa interpolated between its neighbours.
double wall_modulus(double stress_mpa)
{
    for (const auto& [stress, modulus] : {std::pair{0.15, 566e6},
                                          {0.50, 768e6},
                                          {0.75, 912.5e6},
                                          {1.00, 1057e6},
                                          {1.25, 1202e6}})
        if (std::abs(stress - stress_mpa) < 1e-9) return modulus;
    throw std::invalid_argument("no wall modulus at this stress");
}

/// Standard normal by Box and Muller, cut at five: the same on every platform.
double normal(std::mt19937_64& random)
{
    const auto uniform = [&random] {
        return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
    };
    const double r = std::sqrt(-2.0 * std::log(uniform()));
    return std::clamp(r * std::cos(2.0 * std::numbers::pi * uniform()), -3.9,
                      5.0); // keeps factors positive
}

} // namespace

double tan_deg(double degrees) { return std::tan(degrees * std::numbers::pi / 180.0); }

Scene paper_wall(double stress_mpa)
{
    Scene s;
    s.stone = {15.5e9, 0.2, 2300.0};
    s.beam.material = {30e9, 0.2, 7500.0};
    s.loads.vertical_stress = stress_mpa * 1e6;
    s.joint.kn = dem::joint_stiffness(0.10, wall_modulus(stress_mpa), s.stone.young_modulus);
    s.joint.ks = dem::shear_stiffness(s.joint.kn, s.stone.poisson_ratio);
    s.joint.tan_phi = tan_deg(31.8);
    s.crack.kn = 10.0 * s.joint.kn;
    s.crack.ks = dem::shear_stiffness(s.crack.kn, s.stone.poisson_ratio);
    s.crack.ft = s.crack.cohesion = 3.7e6;
    s.crack.tan_phi = s.crack.tan_phi_res = tan_deg(35.0);
    s.crack.fracture_energy = 110.0;
    return s;
}

Scene monolith(double length, double height, double vertical_stress, double joint_kn)
{
    Scene s = paper_wall(0.50);
    s.wall.length = s.wall.unit_length = length;
    s.wall.course_height = height;
    s.wall.courses = 1;
    s.wall.cracks.pattern = {dem::CrackPattern::Kind::none};
    s.wall.base = dem::Base::joint;
    s.beam.material.density = 0.0;
    s.loads.vertical_stress = vertical_stress;
    s.loads.height = height + s.beam.height;
    s.joint.kn = joint_kn;
    s.joint.ks = dem::shear_stiffness(joint_kn, 0.2);
    return s;
}

dem::Model model_of(const Scene& s, const dem::Discretisation& d)
{
    dem::Model m = dem::discretise(s.wall, s.stone, s.beam, s.loads, {s.joint, s.crack}, d);
    m.layout.wear = s.joint.wear.length > 0.0;
    m.layout.closure = s.closure;
    m.layout.crushing = s.joint.crushing.strength > 0.0 || s.crack.crushing.strength > 0.0;
    return m;
}

dem::WallMaterials uniform(const Scene& s, const dem::Model& m)
{
    dem::WallMaterials w;
    w.stone = s.stone;
    w.vertical_stress = s.loads.vertical_stress;
    w.joints.assign(m.layout.n_joints, s.joint);
    w.cracks.assign(m.layout.n_cracks, s.crack);
    w.base_joint = w.beam_joint = s.joint;
    return w;
}

namespace {

/// Table 5: factor on the stiffness of a joint, its friction angle.
dem::JointMaterial draw_joint(dem::JointMaterial joint, double factor, double friction)
{
    joint.kn *= 1.0 + 0.25 * factor;
    joint.ks *= 1.0 + 0.25 * factor;
    joint.tan_phi = tan_deg(31.8 * (1.0 + 0.20 * friction));
    return joint;
}

/// Table 5: factor on the stiffness of a crack, its strength, its friction angle.
dem::CrackMaterial draw_crack(dem::CrackMaterial crack, double factor, double strength,
                              double friction)
{
    crack.kn *= 1.0 + 0.25 * factor;
    crack.ks *= 1.0 + 0.25 * factor;
    crack.ft = crack.cohesion = 1e6 * std::exp(1.265 + 0.294 * strength);
    crack.tan_phi = crack.tan_phi_res = tan_deg(35.0 * (1.0 + 0.20 * friction));
    return crack;
}

} // namespace

dem::WallMaterials table5_sample(const Scene& scene, const dem::Model& m, std::uint64_t sample)
{
    std::mt19937_64 random(1000 + sample);
    double draw[5];
    for (double& d : draw) d = normal(random);
    Scene s = scene;
    s.joint = draw_joint(scene.joint, draw[0], draw[4]);
    s.crack = draw_crack(scene.crack, draw[1], draw[2], draw[3]);
    dem::WallMaterials w = uniform(s, m);
    w.base_joint = w.beam_joint = scene.joint;
    return w;
}

dem::WallMaterials table5_spatial_sample(const Scene& scene, const dem::Model& m,
                                         std::uint64_t sample)
{
    std::mt19937_64 random(500000 + sample);
    dem::WallMaterials w = uniform(scene, m);
    for (dem::JointMaterial& joint : w.joints) {
        const double factor = normal(random);
        joint = draw_joint(scene.joint, factor, normal(random));
    }
    for (dem::CrackMaterial& crack : w.cracks) {
        const double factor = normal(random), strength = normal(random);
        crack = draw_crack(scene.crack, factor, strength, normal(random));
    }
    return w;
}

double peak_force(const dem::PushResult& result)
{
    double peak = 0.0;
    for (const dem::CurvePoint& p : result.curve) peak = std::max(peak, p.force);
    return peak;
}

} // namespace scenes
