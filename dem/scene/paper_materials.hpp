#pragma once
/// The materials of a wall from the parameters that the paper gives: the stiffness of the
/// joints from the elastic modulus of the wall (Eq. 2), cracks that are xi times as stiff as
/// the joints (Table 4), and factors on both stiffnesses that vary from sample to sample (Table
/// 5).

#include "dem/scene/layout.hpp"
#include "dem/scene/wall.hpp"

namespace dem {

/// Eq. 2: joint and stone act as springs in series over one course.
///   k_n = 1 / (h (1/E_wall - 1/E_stone))
/// @param h course height [m];  moduli [Pa], 0 < wall_modulus < stone_modulus
[[nodiscard]] double joint_stiffness(double h, double wall_modulus, double stone_modulus);

/// k_s = k_n / (2 (1 + nu)) (paper, Table 4)
[[nodiscard]] double shear_stiffness(double kn, double poisson_ratio);

/// The joints between units.
struct JointParameters {
    double kn = 0.0;                       ///< normal stiffness, before the factor [Pa/m], > 0
    double ks = 0.0;                       ///< shear stiffness, before the factor [Pa/m], > 0
    double stiffness_factor = 1.0;         ///< on both stiffnesses [-], > 0
    double friction_angle = 0.0;           ///< [rad], in [0, pi/2)
    double tensile_strength = 0.0;         ///< of mortar [Pa], >= 0
    double cohesion = 0.0;                 ///< of mortar [Pa], >= 0
    double fracture_energy = 0.0;          ///< of mortar, mode I [J/m2], >= 0
    Crushing crushing{};                   ///< of the faces, at the base and at the beam too
    double residual_friction_angle = 0.0;  ///< of worn joints [rad]; used with a wear length
    double wear_length = 0.0;              ///< [m], >= 0; 0: no wear
    Closing closing{};                     ///< at the base and at the beam too
    Envelope envelope = Envelope::coulomb; ///< of mortar
    double shear_fracture_energy = 0.0;    ///< of mortar, mode II [J/m2], >= 0; 0: brittle
};

/// Behaviour of a crack that snaps back, f_T > sqrt(2 G k_n), whose softening would end before
/// it begins.
enum class SnapBack {
    breaks, ///< it breaks at f_T, at once, and releases f_T^2/(2 k_n) > G
    weakens ///< it breaks at sqrt(2 G k_n), at once, and releases G
};

/// The potential cracks in units.
struct CrackParameters {
    double stiffness_ratio = 10.0;        ///< xi = k_n of a crack / k_n of a joint [-], > 0
    double tensile_strength = 0.0;        ///< f_T [Pa], >= 0
    double cohesion = 0.0;                ///< [Pa], >= 0
    double residual_cohesion = 0.0;       ///< [Pa], >= 0
    double fracture_energy = 0.0;         ///< G, mode I [J/m2], >= 0
    double friction_angle = 0.0;          ///< [rad], in [0, pi/2)
    double residual_friction_angle = 0.0; ///< [rad], in [0, pi/2)
    double stiffness_factor = 1.0;        ///< on k_n and k_s [-], > 0
    bool tension_reduces_shear = CrackMaterial{}.tension_reduces_shear;
    SnapBack snap_back = SnapBack::breaks;
    Crushing crushing{};
    Envelope envelope = Envelope::coulomb;
    double shear_fracture_energy = 0.0; ///< mode II [J/m2], >= 0; 0: brittle
};

/// The parameters of a wall whose joints are all alike, and whose cracks are.
struct PaperMaterials {
    Elastic stone;
    JointParameters joint;
    CrackParameters crack;
    double base_friction_angle = 0.0; ///< [rad], used with Base::joint
    double beam_friction_angle = 0.0; ///< [rad], used with BeamInterface::joint
};

/// A residual friction angle above the initial one counts as that.
[[nodiscard]] JointMaterial joint_material(const JointParameters& joint);

/// A residual cohesion or friction angle above the initial one, where random draws make it so,
/// counts as the initial one. The two stiffness factors are independent (Table 5): that of the
/// joint does not change the crack.
/// @param joint_kn normal stiffness of a joint before its factor [Pa/m], > 0
[[nodiscard]] CrackMaterial crack_material(const CrackParameters& crack, double joint_kn,
                                           double poisson_ratio);

/// A crack that shares the stiffness of its unit with the pieces on its sides: k_n = k_s =
/// factor x stiffness.
/// @param stiffness [Pa/m], > 0
[[nodiscard]] CrackMaterial crack_material(const CrackParameters& crack, double stiffness);

/// One realisation: the same material for every joint ID and for every crack ID. The joints at
/// the base and at the beam have the stiffness of the others without the factor.
[[nodiscard]] WallMaterials wall_materials(const PaperMaterials& paper, const Layout& layout);

} // namespace dem
