#pragma once
/// The material parameters of a wall, as a study gives them or as one draw makes them, and the
/// materials that follow from them.

#include "dem/scene/closure_fit.hpp"
#include "dem/scene/paper_materials.hpp"
#include "dem/scene/wall.hpp"

#include <vector>

namespace app {

/// Joints between units.
struct JointInput {
    std::vector<double> wall_modulus;   ///< one per stress level [Pa], or empty
    std::vector<double> modulus_stress; ///< where joints close, of each wall modulus [Pa]
    std::vector<double>
        normal_stiffness; ///< one, or one per stress level [Pa/m]; empty: from wall_modulus, or from closing
    /// One, or one per stress level [Pa/m]; empty: of joints that close, from the normal one.
    std::vector<double> shear_stiffness;
    double friction_angle = 0.0;   ///< [rad], in [0, pi/2)
    double stiffness_factor = 1.0; ///< on k_n and k_s [-], > 0
    double tensile_strength = 0.0; ///< of mortar [Pa], >= 0
    double cohesion = 0.0;         ///< of mortar [Pa], >= 0
    double fracture_energy = 0.0;  ///< of mortar, mode I [J/m2], >= 0
    dem::Crushing crushing{};
    double residual_friction_angle = 0.0; ///< of worn joints [rad]
    double wear_length = 0.0;             ///< [m], >= 0; 0: no wear
    dem::Closure closure = dem::Closure::linear;
    dem::Closing closing{};                          ///< used unless closure is linear
    dem::Envelope envelope = dem::Envelope::coulomb; ///< of mortar
    double shear_fracture_energy = 0.0;              ///< of mortar, mode II [J/m2]; 0: brittle
};

/// Whether joints stiffen as they close.
[[nodiscard]] inline bool closes(const JointInput& joint)
{
    return joint.closure != dem::Closure::linear;
}

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

/// The part that has a value of its own where the study is spatial.
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

/// One of the stresses of a study.
struct StressLevel {
    int index = 0;
    double stress = 0.0; ///< vertical [Pa], >= 0
};

/// The one law of closure of several wall moduli.
/// @param course_height h of Eq. 2 [m]
[[nodiscard]] dem::ClosureFit closure_fit(const Parameters& p, double course_height);

/// The stiffness of the joints is that of Eq. 2, or as given; of joints that close, that at the
/// vertical stress.
/// @param course_height h of Eq. 2 [m]
[[nodiscard]] dem::JointMaterial joint_material(const Parameters& p, double course_height,
                                                StressLevel level);
/// @param own stiffness of the crack over Young's modulus of the stone [1/m]; 0: that of the
/// joints gives it
/// (dem::Layout::crack_stiffness)
[[nodiscard]] dem::CrackMaterial crack_material(const Parameters& p, double course_height,
                                                StressLevel level, double own = 0.0);

/// The same material for every joint ID and every crack ID.
[[nodiscard]] dem::WallMaterials materials(const Parameters& p, double course_height,
                                           StressLevel level, const dem::Layout& layout);

} // namespace app
