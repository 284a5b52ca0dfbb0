// The wall of configs/wall.ini, pushed to 30 mm: peak force and 80 % drop. All values in SI.

#include <drystone/dem/block/model.hpp>
#include <drystone/dem/scene/paper_materials.hpp>
#include <drystone/dem/solver/push.hpp>
#include <drystone/fragility/curve/curve_reading.hpp>

#include <cstdio>
#include <numbers>
#include <vector>

int main()
{
    constexpr double degree = std::numbers::pi / 180.0;
    const dem::WallGeometry wall; // 1 m x 1 m x 0.2 m in ten courses of running bond

    dem::PaperMaterials stone;
    stone.stone = {.young_modulus = 15.5e9, .poisson_ratio = 0.2, .density = 2300.0};
    stone.joint.kn = dem::joint_stiffness(wall.course_height, 768e6, 15.5e9);
    stone.joint.ks = dem::shear_stiffness(stone.joint.kn, 0.2);
    stone.joint.friction_angle = 31.8 * degree;
    stone.crack.tensile_strength = stone.crack.cohesion = 3.7e6;
    stone.crack.fracture_energy = 110.0;
    stone.crack.friction_angle = stone.crack.residual_friction_angle = 35.0 * degree;

    dem::Beam beam;
    beam.material = {.young_modulus = 30e9, .poisson_ratio = 0.2, .density = 7500.0};
    dem::Loads loads;
    loads.vertical_stress = 0.5e6;

    const dem::ReferenceStiffness reference = {
        dem::joint_material(stone.joint),
        dem::crack_material(stone.crack, stone.joint.kn, stone.stone.poisson_ratio)};
    const dem::Model model = dem::discretise(wall, stone.stone, beam, loads, reference);

    dem::PushPlan plan;
    plan.targets = {0.030};
    const dem::PushResult result =
        dem::push(model, dem::wall_materials(stone, model.layout), plan);
    if (dem::failed(result.outcome)) return 1;

    std::vector<double> displacement, force;
    for (const dem::CurvePoint& point : result.curve) {
        displacement.push_back(point.displacement);
        force.push_back(point.force);
    }
    const fragility::Curve curve = {displacement, force};
    const fragility::Peak peak = fragility::peak(curve);
    const fragility::LimitDisplacement drop = fragility::drop_after_peak(curve);
    std::printf("peak_force_kN %.15g\n", peak.force * 1e-3);
    std::printf("ultimate_displacement_mm %.15g\n", drop.displacement * 1e3);
    std::printf("energy_residual %.15g\n", result.residual);
}
