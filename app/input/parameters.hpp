#pragma once
/// The material parameters of a wall, as a study gives them or as one draw makes them, and the
/// materials that follow from them.

#include "dem/scene/paper_materials.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace app {

/// Joints between units.
struct JointInput {
    std::vector<double> wall_modulus; ///< one per stress level [Pa], or empty
    std::vector<double>
        normal_stiffness; ///< one, or one per stress level [Pa/m]; empty: from wall_modulus
    std::vector<double> shear_stiffness; ///< one, or one per stress level [Pa/m]
    double friction_angle = 0.0;         ///< [rad], in [0, pi/2)
    double stiffness_factor = 1.0;       ///< on k_n and k_s [-], > 0
    double tensile_strength = 0.0;       ///< of mortar [Pa], >= 0
    double cohesion = 0.0;               ///< of mortar [Pa], >= 0
    double fracture_energy = 0.0;        ///< of mortar, mode I [J/m2], >= 0
    dem::Crushing crushing{};
    double residual_friction_angle = 0.0; ///< of worn joints [rad]
    double wear_length = 0.0;             ///< [m], >= 0; 0: no wear
};

/// Everything that a distribution may stand for, and what it acts on.
struct Parameters {
    dem::Elastic stone;
    JointInput joint;
    dem::CrackParameters unit;        ///< zero strength and zero energy where unit_cracks = no
    double beam_friction_angle = 0.0; ///< [rad], used with BeamInterface::joint
    double base_friction_angle = 0.0; ///< [rad], used with Base::joint
};

/// Where a parameter is kept.
using ParameterPlace = double& (*)(Parameters&);

/// What has a value of its own where the study is spatial.
enum class Varies {
    never,    ///< a number, never a distribution
    by_wall,  ///< one value per wall, in spatial studies too
    by_joint, ///< one per joint ID
    by_crack  ///< one per crack ID
};

/// A parameter that was not given follows from others, and from their draws.
struct ParameterRule {
    void (*apply)(Parameters&, double course_height) = nullptr; ///< height in [m]
    Varies varies = Varies::never; ///< of the parameter that follows
};

/// The stiffness of the joints is that of Eq. 2, or as given.
/// @param course_height h of Eq. 2 [m]
/// @param level index of the stress level
[[nodiscard]] dem::JointMaterial joint_material(const Parameters& p, double course_height,
                                                int level);
/// @param own stiffness of the crack over Young's modulus of the stone [1/m]; 0: that of the joints gives it
/// (dem::Layout::crack_stiffness)
[[nodiscard]] dem::CrackMaterial crack_material(const Parameters& p, double course_height,
                                                int level, double own = 0.0);

/// The same material for every joint ID and every crack ID.
/// @param vertical_stress of the level [Pa]
[[nodiscard]] dem::WallMaterials materials(const Parameters& p, double course_height, int level,
                                           double vertical_stress, const dem::Layout& layout);

} // namespace app
