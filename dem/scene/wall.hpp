#pragma once
/// The wall as an engineer describes it: sizes, bond, supports, loads, and the material of
/// every joint and crack.

#include "dem/contact/contact_options.hpp"
#include "dem/scene/crack_pattern.hpp"

#include <optional>
#include <vector>

namespace dem {

enum class FirstCourse {
    whole,  ///< the bottom course starts with a whole unit
    shifted ///< the bottom course starts with the shorter piece
};
/// How the head joints of a course lie above those of the course below. A header is a unit that
/// lies across the wall.
enum class Bond {
    shifted, ///< whole units, every second course shifted by bond_offset
    english, ///< courses of whole units and courses of headers by turns
    flemish, ///< whole units and headers by turns in every course
    header   ///< headers, every second course shifted by half of one
};
enum class Base {
    fixed, ///< the bottom face of the first course is clamped to the ground (paper, section 3)
    joint  ///< the first course stands on a dry joint and can lift and slide
};
enum class Toe {
    held, ///< the toe side of the first course has no horizontal displacement (paper, section 3)
    free
};
enum class BeamInterface {
    tied, ///< the beam is glued to the top course and the glue is elastic
    joint ///< the beam rests on a dry joint
};
enum class BeamRotation { free, fixed };

struct Elastic {
    double young_modulus = 0.0; ///< [Pa], > 0
    double poisson_ratio = 0.0; ///< [-], in [0, 0.5)
    double density = 0.0;       ///< [kg/m3], >= 0
    friend bool operator==(const Elastic&, const Elastic&) = default;
};

/// A door or a window: a rectangle between courses.
struct Opening {
    double x = 0.0, z = 0.0;          ///< lower left corner [m]
    double width = 0.0, height = 0.0; ///< [m], > 0
    friend bool operator==(const Opening&, const Opening&) = default;
};

/// Geometry and boundary conditions. All lengths in metres.
struct WallGeometry {
    double length = 1.0;         ///< > 0
    double thickness = 0.20;     ///< > 0
    int courses = 10;            ///< >= 1
    double course_height = 0.10; ///< > 0
    /// From the bottom, one for each course, > 0; empty: all are course_height.
    std::vector<double> course_heights;
    double unit_length = 0.20; ///< > 0
    Bond bond = Bond::shifted;
    /// Shift of every second course in unit lengths, in [0, 1); 0 makes a stack bond.
    double bond_offset = 0.5;
    double header_length = 0.10; ///< of a header along the wall, > 0
    /// Coefficient of variation of the length of whole units of Bond::shifted [-], at most
    /// most_length_cov(): their head joints move to either side.
    double length_cov = 0.0;
    unsigned seed = 1; ///< of these moves
    FirstCourse first_course = FirstCourse::whole;
    UnitCracks cracks; ///< by default a potential crack at mid-length of each whole unit
    Base base = Base::fixed;
    Toe toe = Toe::held;
    bool toe_at_left = false;      ///< of a push to the left
    std::vector<Opening> openings; ///< apart, and below the top course
    /// How far the lintel over an opening, one course high, reaches over either side [m], >= 0;
    /// 0: no lintels.
    double lintel_bearing = 0.0;
    Elastic lintel; ///< of these lintels
    friend bool operator==(const WallGeometry&, const WallGeometry&) = default;
};

struct Beam {
    double height = 0.10; ///< [m], > 0
    Elastic material;
    BeamInterface interface = BeamInterface::tied;
    BeamRotation rotation = BeamRotation::free;
    bool present = true; ///< without a beam a wall has body forces only
    friend bool operator==(const Beam&, const Beam&) = default;
};

/// Crushing of a contact under compression; only where Layout::crushing says so.
struct Crushing {
    double strength = 0.0; ///< f_c [Pa], >= 0; 0: never crushes
    double energy = 0.0;   ///< G_c [J/m2], >= 0; 0: keeps its strength
};

/// Wear of a dry joint that slips; only where Layout::wear says so.
struct Wear {
    double tan_phi_res = 0.0; ///< friction coefficient that is left [-], in [0, tan_phi]
    double length = 0.0;      ///< slip that leaves 1/e of the asperities [m], >= 0; 0: no wear
};

/// Constants of a dry joint that closes; used only where Layout::closure is not linear.
struct Closing {
    double initial_stiffness = 0.0; ///< k_0 [Pa/m], > 0
    double maximum = 0.0;           ///< V_m [m], > 0
    double loss =
        0.0; ///< share of the closing work that a cycle of load and unload takes [-], in [0, 1)
    double stiffest = 0.0; ///< normal stiffness that it does not exceed [Pa/m], >= k_0
};

/// A joint: no tension, Coulomb friction, no dilatancy. Mortar bonds it besides, until it is
/// damaged as a crack is; only where Layout::mortar says so.
struct JointMaterial {
    /// Normal and shear stiffness [Pa/m], > 0. Where joints close, that at the vertical stress
    /// of the wall.
    double kn = 0.0, ks = 0.0;
    double tan_phi = 0.0;         ///< friction coefficient [-], >= 0
    double ft = 0.0;              ///< tensile strength of the bond [Pa], >= 0
    double cohesion = 0.0;        ///< of the bond; nothing is left once it is broken [Pa], >= 0
    double fracture_energy = 0.0; ///< of the bond, mode I [J/m2], >= 0
    Crushing crushing{};
    Wear wear{};
    Closing closing{};
    Envelope envelope = Envelope::coulomb; ///< of the bond
    double shear_fracture_energy = 0.0;    ///< of the bond, mode II [J/m2], >= 0; 0: brittle
};

/// A potential crack through a unit (paper, Table 4).
struct CrackMaterial {
    double kn = 0.0;              ///< normal stiffness [Pa/m], > 0
    double ks = 0.0;              ///< shear stiffness [Pa/m], > 0
    double ft = 0.0;              ///< tensile strength [Pa], >= 0
    double cohesion = 0.0;        ///< initial cohesion [Pa], >= 0
    double cohesion_res = 0.0;    ///< residual cohesion [Pa], in [0, cohesion]
    double tan_phi = 0.0;         ///< initial friction coefficient [-], >= 0
    double tan_phi_res = 0.0;     ///< residual friction coefficient [-], >= 0
    double fracture_energy = 0.0; ///< mode I, G [J/m2], >= 0
    /// tau_max = c - sigma tan(theta) in tension too (Table 2, step 5). If false, tau_max = c
    /// in tension.
    bool tension_reduces_shear = true;
    Crushing crushing{};
    Envelope envelope = Envelope::coulomb;
    double shear_fracture_energy = 0.0; ///< mode II [J/m2], >= 0; 0: brittle
};

/// The law of a bonded joint.
[[nodiscard]] inline CrackMaterial bond_of(const JointMaterial& j)
{
    return {.kn = j.kn,
            .ks = j.ks,
            .ft = j.ft,
            .cohesion = j.cohesion,
            .tan_phi = j.tan_phi,
            .tan_phi_res = j.tan_phi,
            .fracture_energy = j.fracture_energy,
            .crushing = j.crushing,
            .envelope = j.envelope,
            .shear_fracture_energy = j.shear_fracture_energy};
}

/// One realisation of everything that may be random: one sample of a study.
struct WallMaterials {
    Elastic
        stone; ///< with the Poisson's ratio of the model, whose modes are those of one ratio
    std::vector<JointMaterial> joints; ///< by joint ID, n_joints (135 for the paper's wall)
    std::vector<CrackMaterial> cracks; ///< by crack ID, n_cracks (45)
    JointMaterial base_joint;          ///< used with Base::joint only
    JointMaterial
        beam_joint; ///< its stiffness is always used, its friction with BeamInterface::joint
    /// On this wall [Pa], >= 0. If it is empty, the stress of the model's loads acts.
    std::optional<double> vertical_stress;
};

/// How the vertical load follows the beam as it moves. Small displacements know no difference.
enum class TopLoad {
    dead,       ///< moves with the beam, as masonry above does
    fixed_line, ///< line of action fixed in space: a jack on rollers that does not move
    follower,   ///< normal to the beam: a jack fixed to it
    link        ///< along a strut to a hinge above, or a tendon to one below
};

/// Load that pushes the wall.
enum class LoadPattern {
    beam, ///< the horizontal displacement of the load line in the beam is prescribed
    body  ///< horizontal forces on all blocks, in proportion to their weight; their conjugate
          ///< displacement, the mean of the blocks' displacements by weight, is prescribed
};

/// Loads on the wall. The vertical stress acts on length x thickness, through the beam.
struct Loads {
    double vertical_stress = 0.0; ///< [Pa], >= 0, compression
    double height = 1.10;  ///< of the horizontal load above the floor [m], within the beam
    double gravity = 9.81; ///< [m/s2], >= 0
    TopLoad top = TopLoad::dead;
    double link_length = 0.0; ///< of TopLoad::link [m]: > 0 hinge above the beam, < 0 below
    LoadPattern pattern = LoadPattern::beam;
};

} // namespace dem
