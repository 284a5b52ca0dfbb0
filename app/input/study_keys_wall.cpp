/// The wall and its materials: keys of the study file.

#include "app/input/study_key_table.hpp"

#include <array>

namespace app {
namespace {

using dem::Beam;
using dem::CrackParameters;
using dem::Elastic;
using dem::SolverOptions;
using dem::WallGeometry;

constexpr std::array kBonds = {named("running", 0.5), named("stack", 0)};
constexpr std::array kYesNo = {named("yes", true), named("no", false)};
constexpr std::array kFirstCourses = {named("whole", dem::FirstCourse::whole),
                                      named("shifted", dem::FirstCourse::shifted)};
constexpr std::array kBases = {named("fixed", dem::Base::fixed),
                               named("joint", dem::Base::joint)};
constexpr std::array kToes = {named("held", dem::Toe::held), named("free", dem::Toe::free)};
constexpr std::array kInterfaces = {named("tied", dem::BeamInterface::tied),
                                    named("joint", dem::BeamInterface::joint)};
constexpr std::array kRotations = {named("free", dem::BeamRotation::free),
                                   named("fixed", dem::BeamRotation::fixed)};
constexpr std::array kLaws = {named("coupled", dem::ContactLaw::coupled),
                              named("uncoupled", dem::ContactLaw::uncoupled)};
constexpr std::array kSnapBacks = {named("breaks", dem::SnapBack::breaks),
                                   named("weakens", dem::SnapBack::weakens)};
constexpr std::array kUnloadings = {named("secant", dem::Unloading::secant),
                                    named("elastic", dem::Unloading::elastic)};

void derive_shear_stiffness(Study& s)
{
    std::vector<double> kn = s.joint.normal_stiffness;
    for (const double modulus : s.joint.wall_modulus) {
        kn.push_back(
            dem::joint_stiffness(s.wall.course_height, modulus, s.stone.young_modulus));
    }
    for (double& k : kn) k = dem::shear_stiffness(k, s.stone.poisson_ratio);
    s.joint.shear_stiffness = kn;
}

// The ends of the ranges are beyond any wall: they catch a wrong power of ten.
constexpr Range kLength{'[', 0.001, 100, ']'}; // [m]
constexpr Range kHeight{'[', 0.001, 10, ']'};  // [m]
constexpr Range kModulus{'(', 0, 1000, ']'};   // [GPa]
constexpr Range kPoisson{'[', 0, 0.5, ')'};    // [-]
constexpr Range kDensity{'[', 0, 20000, ']'};  // [kg/m3]
constexpr Range kStiffness{'(', 0, 1e6, ']'};  // [GPa/m]
constexpr Range kAngle{'[', 0, 90, ')'};       // [deg]
constexpr Range kStrength{'[', 0, 1000, ']'};  // [MPa]
constexpr Range kFactor{'(', 0, 1000, ']'};    // [-]

// clang-format off
constexpr std::array kKeys = {
    Key{.name = "wall.length", .unit = "m", .range = kLength, .example = "1.00 m",
        .meaning = "along the push",
        .field = kAt<&Study::wall, &WallGeometry::length>},
    Key{.name = "wall.courses", .kind = Kind::count, .range = {'[', 1, 1000, ']'}, .example = "10",
        .meaning = "number of courses",
        .field = kAt<&Study::wall, &WallGeometry::courses>},
    Key{.name = "wall.course_height", .unit = "m", .range = kHeight, .example = "0.10 m",
        .meaning = "height of a course, h of Eq. 2",
        .field = kAt<&Study::wall, &WallGeometry::course_height>},
    Key{.name = "wall.unit_length", .unit = "m", .range = kLength, .example = "0.20 m",
        .meaning = "length of a whole unit",
        .field = kAt<&Study::wall, &WallGeometry::unit_length>},
    Key{.name = "wall.thickness", .unit = "m", .range = kLength, .example = "0.20 m",
        .meaning = "of the wall, out of plane",
        .field = kAt<&Study::wall, &WallGeometry::thickness>},
    Key{.name = "wall.bond", .range = {'[', 0, 1, ')'}, .names = kBonds,
        .meaning = "shift of every second course in unit lengths; running 0.5, stack 0",
        .field = kAt<&Study::wall, &WallGeometry::bond_offset>},
    Key{.name = "wall.first_course", .kind = Kind::word, .names = kFirstCourses,
        .meaning = "bottom course starts with a whole unit or with the shifted piece",
        .field = kAt<&Study::wall, &WallGeometry::first_course>},
    Key{.name = "wall.unit_cracks", .kind = Kind::word, .names = kYesNo,
        .meaning = "a potential crack at mid-length of each whole unit (paper, Fig. 2)",
        .field = kAt<&Study::wall, &WallGeometry::cracks_in_units>},
    Key{.name = "wall.base", .kind = Kind::word, .names = kBases,
        .meaning = "bottom face clamped (paper, section 3), or on a dry joint",
        .field = kAt<&Study::wall, &WallGeometry::base>},
    Key{.name = "wall.toe", .kind = Kind::word, .names = kToes,
        .meaning = "toe side of the first course held sideways (paper, section 3)",
        .field = kAt<&Study::wall, &WallGeometry::toe>},

    Key{.name = "stone.young_modulus", .unit = "GPa", .range = kModulus, .example = "15.5 GPa",
        .varies = Varies::by_wall,
        .meaning = "E_stone of Eq. 2",
        .field = kAt<&Study::stone, &Elastic::young_modulus>},
    Key{.name = "stone.poisson_ratio", .range = kPoisson, .example = "0.2",
        .fixed_because = "because the walls of a study share the deformation modes of their blocks (through the "
                         "blocks, 0.1 to 0.3 moves the stiffness of the paper's wall by 0.6 % and its peak by 0.1 %)",
        .meaning = "also of k_s = k_n / (2 (1 + nu)) (paper, Table 4)",
        .field = kAt<&Study::stone, &Elastic::poisson_ratio>},
    Key{.name = "stone.density", .unit = "kg/m3", .range = kDensity, .example = "2300 kg/m3",
        .varies = Varies::by_wall,
        .meaning = "self-weight of the wall",
        .field = kAt<&Study::stone, &Elastic::density>},

    Key{.name = "joint.wall_modulus", .kind = Kind::list, .unit = "MPa", .range = {'(', 0, 1e6, ']'},
        .derived = {"or normal_stiffness"},
        .meaning = "one per stress level, gives k_n by Eq. 2 (paper, Table 3)",
        .field = kAt<&Study::joint, &JointInput::wall_modulus>},
    Key{.name = "joint.normal_stiffness", .kind = Kind::list, .unit = "GPa/m", .range = kStiffness,
        .derived = {"from wall_modulus"},
        .meaning = "k_n, one or one per stress level; in place of wall_modulus",
        .field = kAt<&Study::joint, &JointInput::normal_stiffness>},
    Key{.name = "joint.shear_stiffness", .kind = Kind::list, .unit = "GPa/m", .range = kStiffness,
        .derived = {"k_n / (2 (1 + nu))", derive_shear_stiffness},
        .meaning = "k_s, one or one per stress level (paper, Table 4)",
        .field = kAt<&Study::joint, &JointInput::shear_stiffness>},
    Key{.name = "joint.friction_angle", .unit = "deg", .range = kAngle, .example = "31.8 deg",
        .varies = Varies::by_joint,
        .meaning = "of the dry joints (paper, Table 4)",
        .field = kAt<&Study::joint, &JointInput::friction_angle>},
    Key{.name = "joint.stiffness_factor", .range = kFactor,
        .varies = Varies::by_joint,
        .meaning = "on k_n and k_s of the joints (paper, Table 5)",
        .field = kAt<&Study::joint, &JointInput::stiffness_factor>},

    Key{.name = "unit.stiffness_ratio", .range = {'(', 0, 1e6, ']'}, .used = Used::with_cracks,
        .varies = Varies::by_crack,
        .meaning = "xi = k_n of a crack / k_n of a joint (paper, Table 4)",
        .field = kAt<&Study::unit, &CrackParameters::stiffness_ratio>},
    Key{.name = "unit.tensile_strength", .unit = "MPa", .range = kStrength,
        .used = Used::with_cracks, .example = "3.7 MPa",
        .varies = Varies::by_crack,
        .meaning = "f_T of the units (paper, Table 4)",
        .field = kAt<&Study::unit, &CrackParameters::tensile_strength>},
    Key{.name = "unit.cohesion", .unit = "MPa", .range = kStrength, .used = Used::with_cracks,
        .derived = {"tensile_strength", [](Study& s) { s.unit.cohesion = s.unit.tensile_strength; }},
        .varies = Varies::by_crack,
        .meaning = "initial (paper, Table 4)",
        .field = kAt<&Study::unit, &CrackParameters::cohesion>},
    Key{.name = "unit.residual_cohesion", .unit = "MPa", .range = kStrength,
        .used = Used::with_cracks,
        .varies = Varies::by_crack,
        .meaning = "at most the initial one",
        .field = kAt<&Study::unit, &CrackParameters::residual_cohesion>},
    Key{.name = "unit.fracture_energy", .unit = "N/m", .range = {'[', 0, 1e6, ']'},
        .used = Used::with_cracks, .example = "110 N/m",
        .varies = Varies::by_crack,
        .meaning = "mode I (paper, Table 4)",
        .field = kAt<&Study::unit, &CrackParameters::fracture_energy>},
    Key{.name = "unit.friction_angle", .unit = "deg", .range = kAngle, .used = Used::with_cracks,
        .example = "35 deg",
        .varies = Varies::by_crack,
        .meaning = "initial, of a crack (paper, Table 4)",
        .field = kAt<&Study::unit, &CrackParameters::friction_angle>},
    Key{.name = "unit.residual_friction_angle", .unit = "deg", .range = kAngle,
        .used = Used::with_cracks,
        .derived = {"friction_angle",
                    [](Study& s) { s.unit.residual_friction_angle = s.unit.friction_angle; }},
        .varies = Varies::by_crack,
        .meaning = "at most the initial one (paper, Table 4)",
        .field = kAt<&Study::unit, &CrackParameters::residual_friction_angle>},
    Key{.name = "unit.stiffness_factor", .range = kFactor, .used = Used::with_cracks,
        .varies = Varies::by_crack,
        .meaning = "on k_n and k_s of the cracks (paper, Table 5)",
        .field = kAt<&Study::unit, &CrackParameters::stiffness_factor>},
    Key{.name = "unit.contact_law", .kind = Kind::word, .names = kLaws, .used = Used::with_cracks,
        .meaning = "damage of tension and shear together (paper, Table 2) or apart (Fig. 7)",
        .field = kAt<&Study::solver, &SolverOptions::law>},
    Key{.name = "unit.tension_reduces_shear", .kind = Kind::word, .names = kYesNo,
        .used = Used::with_cracks,
        .meaning = "tau_max = c - sigma tan(theta) in tension too (paper, Table 2, step 5), or c there",
        .field = kAt<&Study::unit, &CrackParameters::tension_reduces_shear>},
    Key{.name = "unit.snap_back", .kind = Kind::word, .names = kSnapBacks,
        .used = Used::with_cracks,
        .meaning = "where f_T > sqrt(2 G k_n) a crack breaks at f_T, or is weakened to that value",
        .field = kAt<&Study::unit, &CrackParameters::snap_back>},
    Key{.name = "unit.unloading", .kind = Kind::word, .names = kUnloadings,
        .used = Used::with_cracks,
        .meaning = "an open crack closes to the origin, or with k_n (paper, Table 1) and stays propped",
        .field = kAt<&Study::solver, &SolverOptions::unloading>},

    Key{.name = "beam.height", .unit = "m", .range = kHeight, .example = "0.10 m",
        .meaning = "of the loading beam on the wall",
        .field = kAt<&Study::beam, &Beam::height>},
    Key{.name = "beam.young_modulus", .unit = "GPa", .range = kModulus, .example = "30 GPa",
        .meaning = "of the loading beam",
        .field = kAt<&Study::beam, &Beam::material, &Elastic::young_modulus>},
    Key{.name = "beam.poisson_ratio", .range = kPoisson,
        .meaning = "of the loading beam; concrete",
        .field = kAt<&Study::beam, &Beam::material, &Elastic::poisson_ratio>},
    Key{.name = "beam.density", .unit = "kg/m3", .range = kDensity, .example = "2400 kg/m3",
        .meaning = "weight of the loading beam",
        .field = kAt<&Study::beam, &Beam::material, &Elastic::density>},
    Key{.name = "beam.interface", .kind = Kind::word, .names = kInterfaces,
        .meaning = "beam glued to the top course, or on a dry joint",
        .field = kAt<&Study::beam, &Beam::interface>},
    Key{.name = "beam.friction_angle", .unit = "deg", .range = kAngle,
        .used = Used::with_beam_joint,
        .derived = {"joint.friction_angle",
                    [](Study& s) { s.beam_friction_angle = s.joint.friction_angle; }},
        .varies = Varies::by_wall,
        .meaning = "under the beam, only with interface = joint",
        .field = kAt<&Study::beam_friction_angle>},
    Key{.name = "beam.rotation", .kind = Kind::word, .names = kRotations,
        .meaning = "the beam may turn, or stays level",
        .field = kAt<&Study::beam, &Beam::rotation>},

    Key{.name = "base.friction_angle", .unit = "deg", .range = kAngle,
        .used = Used::with_base_joint,
        .derived = {"joint.friction_angle",
                    [](Study& s) { s.base_friction_angle = s.joint.friction_angle; }},
        .varies = Varies::by_wall,
        .meaning = "under the first course, only with wall.base = joint",
        .field = kAt<&Study::base_friction_angle>},
};
// clang-format on

} // namespace

std::span<const Key> wall_keys() { return kKeys; }

} // namespace app
