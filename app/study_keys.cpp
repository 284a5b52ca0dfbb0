#include "app/study_keys.hpp"

#include <array>

namespace app {
namespace {

using dem::Beam;
using dem::Discretisation;
using dem::Elastic;
using Mode = dem::ModeThresholds;
using dem::SolverOptions;
using dem::WallGeometry;

constexpr Named named(std::string_view word, auto value)
{
    return {word, static_cast<double>(value)};
}

constexpr std::array kBonds = {named("running", 0.5), named("stack", 0)};
constexpr std::array kYesNo = {named("yes", true), named("no", false)};
constexpr std::array kPrecisions = {named("double", false), named("single", true)};
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
constexpr std::array kSnapBacks = {named("breaks", SnapBack::breaks),
                                   named("weakens", SnapBack::weakens)};
constexpr std::array kUnloadings = {named("secant", dem::Unloading::secant),
                                    named("elastic", dem::Unloading::elastic)};
constexpr std::array kFaceRules = {named("even", dem::FaceRule::even),
                                   named("lobatto", dem::FaceRule::lobatto)};
constexpr std::array kDampings = {named("local", dem::Damping::local),
                                  named("combined", dem::Damping::combined)};
constexpr std::array kPreloads = {named("solved", dem::Preload::solved),
                                  named("ramped", dem::Preload::ramped)};
constexpr std::array kFidelities = {
    named("rigid", dem::Fidelity::rigid), named("simple", dem::Fidelity::simple),
    named("standard", dem::Fidelity::standard), named("zones", dem::Fidelity::zones),
    named("fine", dem::Fidelity::fine)};
constexpr std::array kDesigns = {named("lhs", uq::DesignKind::latin_random),
                                 named("lhs_centred", uq::DesignKind::latin_centred),
                                 named("lhs_optimised", uq::DesignKind::latin_optimised),
                                 named("monte_carlo", uq::DesignKind::monte_carlo),
                                 named("sobol", uq::DesignKind::sobol)};
constexpr std::array kMethods = {named("monte_carlo", ReliabilityMethod::monte_carlo),
                                 named("form", ReliabilityMethod::form),
                                 named("importance", ReliabilityMethod::importance),
                                 named("subset", ReliabilityMethod::subset),
                                 named("multi_fidelity", ReliabilityMethod::multi_fidelity)};
constexpr std::array kWallResponses = {
    named("peak_force", WallResponse::peak_force),
    named("ultimate_displacement", WallResponse::ultimate_displacement),
    named("ultimate_drift", WallResponse::ultimate_drift)};
constexpr std::array kSpatial = {
    named("none", Spatial::none), named("independent", Spatial::independent),
    named("stratified", Spatial::stratified), named("correlated", Spatial::correlated)};
constexpr std::array kStops = {
    named("none", StopQuantity::none), named("peak_force", StopQuantity::peak_force),
    named("ultimate_displacement", StopQuantity::ultimate_displacement),
    named("mixed_share", StopQuantity::mixed_share)};
constexpr std::array kKernels = {named("exponential", FieldKernel::exponential),
                                 named("squared_exponential", FieldKernel::squared_exponential),
                                 named("exponential_l1", FieldKernel::exponential_l1),
                                 named("matern", FieldKernel::matern),
                                 named("same_course", FieldKernel::same_course),
                                 named("same_unit", FieldKernel::same_unit),
                                 named("all", FieldKernel::all)};
constexpr std::array kCrossings = {named("first", fragility::Crossing::first),
                                   named("last", fragility::Crossing::last)};
constexpr std::array kDriftLaws = {
    named("lognormal", fragility::Law::lognormal), named("normal", fragility::Law::normal),
    named("weibull", fragility::Law::weibull), named("gamma", fragility::Law::gamma)};
constexpr std::array kModes = {named("all", 0), named("rigid", 3)};

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

void derive_load_height(Study& s)
{
    s.load.height = s.wall.courses * s.wall.course_height + s.beam.height;
}

void derive_contact_points(Study& s)
{
    s.discretisation.contact_points = dem::discretisation_of(s.fidelity).contact_points;
}

void derive_block_modes(Study& s)
{
    s.discretisation.block_modes = dem::discretisation_of(s.fidelity).block_modes;
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
constexpr Range kModeCount{'[', 3, 1000, ']'}; // [-]

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
        .varies = Varies::by_wall,
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
        .field = kAt<&Study::unit, &UnitInput::stiffness_ratio>},
    Key{.name = "unit.tensile_strength", .unit = "MPa", .range = kStrength,
        .used = Used::with_cracks, .example = "3.7 MPa",
        .varies = Varies::by_crack,
        .meaning = "f_T of the units (paper, Table 4)",
        .field = kAt<&Study::unit, &UnitInput::tensile_strength>},
    Key{.name = "unit.cohesion", .unit = "MPa", .range = kStrength, .used = Used::with_cracks,
        .derived = {"tensile_strength", [](Study& s) { s.unit.cohesion = s.unit.tensile_strength; }},
        .varies = Varies::by_crack,
        .meaning = "initial (paper, Table 4)",
        .field = kAt<&Study::unit, &UnitInput::cohesion>},
    Key{.name = "unit.residual_cohesion", .unit = "MPa", .range = kStrength,
        .used = Used::with_cracks,
        .varies = Varies::by_crack,
        .meaning = "at most the initial one",
        .field = kAt<&Study::unit, &UnitInput::residual_cohesion>},
    Key{.name = "unit.fracture_energy", .unit = "N/m", .range = {'[', 0, 1e6, ']'},
        .used = Used::with_cracks, .example = "110 N/m",
        .varies = Varies::by_crack,
        .meaning = "mode I (paper, Table 4)",
        .field = kAt<&Study::unit, &UnitInput::fracture_energy>},
    Key{.name = "unit.friction_angle", .unit = "deg", .range = kAngle, .used = Used::with_cracks,
        .example = "35 deg",
        .varies = Varies::by_crack,
        .meaning = "initial, of a crack (paper, Table 4)",
        .field = kAt<&Study::unit, &UnitInput::friction_angle>},
    Key{.name = "unit.residual_friction_angle", .unit = "deg", .range = kAngle,
        .used = Used::with_cracks,
        .derived = {"friction_angle",
                    [](Study& s) { s.unit.residual_friction_angle = s.unit.friction_angle; }},
        .varies = Varies::by_crack,
        .meaning = "at most the initial one (paper, Table 4)",
        .field = kAt<&Study::unit, &UnitInput::residual_friction_angle>},
    Key{.name = "unit.stiffness_factor", .range = kFactor, .used = Used::with_cracks,
        .varies = Varies::by_crack,
        .meaning = "on k_n and k_s of the cracks (paper, Table 5)",
        .field = kAt<&Study::unit, &UnitInput::stiffness_factor>},
    Key{.name = "unit.contact_law", .kind = Kind::word, .names = kLaws, .used = Used::with_cracks,
        .meaning = "damage of tension and shear together (paper, Table 2) or apart (Fig. 7)",
        .field = kAt<&Study::solver, &SolverOptions::law>},
    Key{.name = "unit.tension_reduces_shear", .kind = Kind::word, .names = kYesNo,
        .used = Used::with_cracks,
        .meaning = "tau_max = c - sigma tan(theta) in tension too (paper, Table 2, step 5), or c there",
        .field = kAt<&Study::unit, &UnitInput::tension_reduces_shear>},
    Key{.name = "unit.snap_back", .kind = Kind::word, .names = kSnapBacks,
        .used = Used::with_cracks,
        .meaning = "where f_T > sqrt(2 G k_n) a crack breaks at f_T, or is weakened to that value",
        .field = kAt<&Study::unit, &UnitInput::snap_back>},
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

    Key{.name = "load.vertical_stress", .kind = Kind::list, .unit = "MPa", .range = kStrength,
        .example = "0.50 MPa",
        .meaning = "stress levels, through the beam on length x thickness",
        .field = kAt<&Study::load, &LoadInput::vertical_stress>},
    Key{.name = "load.height", .unit = "m", .range = {'(', 0, 10010, ']'},
        .derived = {"top of the beam", derive_load_height},
        .meaning = "of the horizontal load above the floor, within the beam",
        .field = kAt<&Study::load, &LoadInput::height>},
    Key{.name = "load.max_displacement", .unit = "mm", .range = {'(', 0, 1000, ']'},
        .meaning = "of the load line; targets replace it",
        .field = kAt<&Study::load, &LoadInput::max_displacement>},
    Key{.name = "load.targets", .kind = Kind::list, .unit = "mm", .range = {'[', -1000, 1000, ']'},
        .derived = {"max_displacement"},
        .meaning = "displacements visited in order; cyclic pushes change sign",
        .field = kAt<&Study::load, &LoadInput::targets>},
    Key{.name = "load.stop_below", .range = {'[', 0, 1, ')'},
        .meaning = "ends the push once the force is below this share of the peak; 0 never",
        .field = kAt<&Study::load, &LoadInput::stop_below>},
    Key{.name = "load.gravity", .unit = "m/s2", .range = {'[', 0, 100, ']'},
        .meaning = "acceleration of free fall",
        .field = kAt<&Study::load, &LoadInput::gravity>},

    Key{.name = "solver.fidelity", .kind = Kind::word, .names = kFidelities,
        .meaning = "rung of the ladder from rigid blocks to fine zones (docs/bench/paper_walls.md)",
        .field = kAt<&Study::fidelity>},
    Key{.name = "solver.contact_points", .kind = Kind::count, .range = {'[', 2, 100, ']'},
        .derived = {"of fidelity", derive_contact_points},
        .meaning = "per face of a half unit",
        .field = kAt<&Study::discretisation, &Discretisation::contact_points>},
    Key{.name = "solver.face_rule", .kind = Kind::word, .names = kFaceRules,
        .meaning = "contact points evenly spaced, or Gauss-Lobatto",
        .field = kAt<&Study::discretisation, &Discretisation::face_rule>},
    Key{.name = "solver.zones_per_interval", .kind = Kind::count, .range = {'[', 1, 100, ']'},
        .meaning = "block zones between two contact points",
        .field = kAt<&Study::discretisation, &Discretisation::zones_per_interval>},
    Key{.name = "solver.block_modes", .kind = Kind::count, .range = kModeCount, .names = kModes,
        .derived = {"of fidelity", derive_block_modes},
        .meaning = "deformation modes of a block: rigid 3, simply deformable 6, ... all",
        .field = kAt<&Study::discretisation, &Discretisation::block_modes>},
    Key{.name = "solver.beam_modes", .kind = Kind::count, .range = kModeCount, .names = kModes,
        .meaning = "deformation modes of the loading beam",
        .field = kAt<&Study::discretisation, &Discretisation::beam_modes>},
    Key{.name = "solver.damping", .kind = Kind::word, .names = kDampings,
        .meaning = "local (paper, Eq. 1), or combined: no drag on steady motion",
        .field = kAt<&Study::solver, &SolverOptions::damping>},
    Key{.name = "solver.damping_factor", .range = {'(', 0, 1, ')'},
        .meaning = "gamma of Eq. 1",
        .field = kAt<&Study::solver, &SolverOptions::damping_factor>},
    Key{.name = "solver.step_fraction", .range = {'(', 0, 1, ']'},
        .meaning = "of the largest stable step",
        .field = kAt<&Study::solver, &SolverOptions::step_fraction>},
    Key{.name = "solver.steps_per_mm", .range = {'[', 1, 1e9, ']'},
        .meaning = "explicit steps to a millimetre of the load line's way at full speed",
        .field = kAt<&Study::solver, &SolverOptions::steps_per_mm>},
    Key{.name = "solver.preload", .kind = Kind::word, .names = kPreloads,
        .meaning = "the vertical load: from the static solution, or by a ramp",
        .field = kAt<&Study::solver, &SolverOptions::preload>},
    Key{.name = "solver.preload_steps", .kind = Kind::count, .range = {'[', 1, 1e12, ']'},
        .meaning = "at most, to come to rest under the vertical load",
        .field = kAt<&Study::solver, &SolverOptions::preload_steps>},
    Key{.name = "solver.preload_unbalance", .range = {'(', 0, 1, ')'},
        .meaning = "unbalanced / applied load at which the vertical load counts as carried",
        .field = kAt<&Study::solver, &SolverOptions::preload_unbalance>},
    Key{.name = "solver.unbalance_limit", .range = {'[', 0, 1, ']'},
        .meaning = "|top - base shear| / vertical load above which the drive slows; 0 never",
        .field = kAt<&Study::solver, &SolverOptions::unbalance_limit>},
    Key{.name = "solver.min_speed", .range = {'(', 0, 1, ']'},
        .meaning = "slowest drive, as a share of full speed",
        .field = kAt<&Study::solver, &SolverOptions::min_speed>},

    Key{.name = "solver.energy_tolerance", .range = {'(', 0, 1, ')'},
        .meaning = "largest energy residual; beyond it the step is halved, in the end the wall failed",
        .field = kAt<&Study::solver, &SolverOptions::energy_tolerance>},
    Key{.name = "solver.most_steps", .kind = Kind::count, .range = {'[', 1, 1e12, ']'},
        .meaning = "of one wall; a wall that needs more has failed",
        .field = kAt<&Study::solver, &SolverOptions::most_steps>},

    Key{.name = "output.record_every", .unit = "mm", .range = {'(', 0, 1000, ']'},
        .meaning = "spacing of the points of the capacity curve",
        .field = kAt<&Study::output, &OutputInput::record_every>},
    Key{.name = "output.snapshot_every", .unit = "mm", .range = {'[', 0, 1000, ']'},
        .meaning = "spacing of the ParaView series; 0 only both ends",
        .field = kAt<&Study::output, &OutputInput::snapshot_every>},
    Key{.name = "output.curves", .kind = Kind::word, .names = kPrecisions,
        .meaning = "precision of the curves in the file of a study; single: half the size",
        .field = kAt<&Study::output, &OutputInput::single_precision_curves>},

    Key{.name = "uq.design", .kind = Kind::word, .names = kDesigns,
        .meaning = "how the samples are drawn; lhs: Latin hypercube",
        .field = kAt<&Study::uq, &UqInput::design>},
    Key{.name = "uq.samples", .kind = Kind::count, .range = {'[', 1, 1e7, ']'},
        .meaning = "walls per stress level; a larger number adds walls and keeps the old",
        .field = kAt<&Study::uq, &UqInput::samples>},
    Key{.name = "uq.seed", .kind = Kind::count, .range = {'[', 0, 9e15, ']'},
        .meaning = "another seed gives other samples",
        .field = kAt<&Study::uq, &UqInput::seed>},
    Key{.name = "uq.shared", .kind = Kind::word, .names = kYesNo,
        .meaning = "the same samples under every stress level, or a design of its own for each (paper)",
        .field = kAt<&Study::uq, &UqInput::shared>},
    Key{.name = "uq.spatial", .kind = Kind::word, .names = kSpatial,
        .meaning = "one value per wall, or per joint ID: independent, stratified in each wall, correlated",
        .field = kAt<&Study::uq, &UqInput::spatial>},
    Key{.name = "uq.kernel", .kind = Kind::word, .names = kKernels, .used = Used::with_fields,
        .meaning = "correlation between joints by distance of their centres, or by group",
        .field = kAt<&Study::uq, &UqInput::kernel>},
    Key{.name = "uq.correlation_length", .kind = Kind::list, .unit = "m", .range = {'(', 0, 1e6, ']'},
        .used = Used::with_fields,
        .derived = {"must be given with kernels by distance"},
        .meaning = "of kernels by distance; two values for exponential_l1, along x and z",
        .field = kAt<&Study::uq, &UqInput::correlation_length>},
    Key{.name = "uq.matern_nu", .range = {'[', 0.05, 50, ']'}, .used = Used::with_fields,
        .meaning = "smoothness of the kernel matern",
        .field = kAt<&Study::uq, &UqInput::matern_nu>},
    Key{.name = "uq.group_correlation", .range = {'[', 0, 1, ']'}, .used = Used::with_fields,
        .meaning = "between joints of one group, kernels same_course, same_unit, all",
        .field = kAt<&Study::uq, &UqInput::group_correlation>},
    Key{.name = "uq.stop", .kind = Kind::word, .names = kStops,
        .meaning = "adds walls until the 95 % interval of this mean, or share, is narrow enough at every level",
        .field = kAt<&Study::uq, &UqInput::stop>},
    Key{.name = "uq.stop_half_width", .range = {'(', 0, 1, ']'},
        .meaning = "of that interval, as a share of the mean; of mixed_share as it is",
        .field = kAt<&Study::uq, &UqInput::stop_half_width>},
    Key{.name = "uq.most_samples", .kind = Kind::count, .range = {'[', 1, 1e7, ']'},
        .meaning = "at which the rule gives up",
        .field = kAt<&Study::uq, &UqInput::most_samples>},
    Key{.name = "uq.pearson", .kind = Kind::text,
        .derived = {"none"},
        .meaning = "correlated variables: joint.friction_angle joint.stiffness_factor 0.3, ...",
        .field = kAt<&Study::uq, &UqInput::pearson>},

    Key{.name = "reliability.method", .kind = Kind::word, .names = kMethods,
        .meaning = "form: design point, FORM and SORM; importance: sampling around it; subset: small probabilities",
        .field = kAt<&Study::reliability, &ReliabilityInput::method>},
    Key{.name = "reliability.response", .kind = Kind::word, .names = kWallResponses,
        .meaning = "that is to fall to the demand or below; ultimate: 80 % of the peak",
        .field = kAt<&Study::reliability, &ReliabilityInput::response>},
    Key{.name = "reliability.demand", .kind = Kind::text,
        .derived = {"must be given for reliability"},
        .meaning = "40 kN, 15 mm, or 1.2 for a drift of 1.2 %",
        .field = kAt<&Study::reliability, &ReliabilityInput::demand>},
    Key{.name = "reliability.budget", .kind = Kind::count, .range = {'[', 10, 1e8, ']'},
        .meaning = "walls at most; subset: per level; multi_fidelity: their cost",
        .field = kAt<&Study::reliability, &ReliabilityInput::budget>},
    Key{.name = "reliability.target_cov", .range = {'(', 0, 10, ']'},
        .meaning = "stops once the probability has this coefficient of variation",
        .field = kAt<&Study::reliability, &ReliabilityInput::target_cov>},
    Key{.name = "reliability.cheap", .kind = Kind::word, .names = kFidelities,
        .meaning = "fidelity of the cheap model of multi_fidelity",
        .field = kAt<&Study::reliability, &ReliabilityInput::cheap>},

    Key{.name = "fragility.limit_states", .kind = Kind::text,
        .meaning = "sets, one or more of paper, ntc, ec8, user (docs/fragility.md)",
        .field = kAt<&Study::fragility, &FragilityInput::limit_states>},
    Key{.name = "fragility.user_states", .kind = Kind::text,
        .derived = {"none"},
        .meaning = "of the set user: slight: 0.7 yield; heavy: 0.5 yield + 0.5 ultimate; near: ultimate or 1.0 %",
        .field = kAt<&Study::fragility, &FragilityInput::user_states>},
    Key{.name = "fragility.crossing", .kind = Kind::word, .names = kCrossings,
        .meaning = "which fall to ultimate_share counts on a jerky curve",
        .field = kAt<&Study::fragility, &FragilityInput::crossing>},
    Key{.name = "fragility.ultimate_share", .range = {'(', 0, 1, ')'},
        .meaning = "of the peak force, at the ultimate displacement (paper, section 4.2)",
        .field = kAt<&Study::fragility, &FragilityInput::ultimate_share>},
    Key{.name = "fragility.bilinear_share", .range = {'(', 0, 1, ']'},
        .meaning = "of the peak force, through which the bilinear rises (Circolare 7/2019, C7.3.4.2)",
        .field = kAt<&Study::fragility, &FragilityInput::bilinear_share>},
    Key{.name = "fragility.law", .kind = Kind::word, .names = kDriftLaws,
        .meaning = "of limit drifts",
        .field = kAt<&Study::fragility, &FragilityInput::law>},
    Key{.name = "fragility.confidence", .range = {'(', 0, 1, ')'},
        .meaning = "of all intervals",
        .field = kAt<&Study::fragility, &FragilityInput::confidence>},
    Key{.name = "fragility.bootstrap", .kind = Kind::count, .range = {'[', 0, 1e6, ']'},
        .meaning = "samples behind the p-values of fits; 0 none",
        .field = kAt<&Study::fragility, &FragilityInput::bootstrap>},
    Key{.name = "fragility.rotation_share", .range = {'(', 0, 1, ')'},
        .meaning = "rotation / displacement below which a cracked wall is of mixed mode",
        .field = kAt<&Study::fragility, &FragilityInput::mode, &Mode::rotation_share>},
    Key{.name = "fragility.cracked_units", .kind = Kind::count, .range = {'[', 0, 1e6, ']'},
        .meaning = "units cracked through from which it counts as cracked; 0: sliding is enough",
        .field = kAt<&Study::fragility, &FragilityInput::mode, &Mode::cracked_units>},
};
// clang-format on

} // namespace

std::span<const Key> study_keys() { return kKeys; }

std::string_view section_of(std::string_view key) { return key.substr(0, key.find('.')); }

std::string_view name_in_section(std::string_view key) { return key.substr(key.find('.') + 1); }

const Key* find_key(std::string_view name)
{
    for (const Key& key : kKeys)
        if (key.name == name) return &key;
    return nullptr;
}

bool is_used(const Key& key, const Study& study)
{
    switch (key.used) {
    case Used::always:
        return true;
    case Used::with_cracks:
        return study.wall.cracks_in_units;
    case Used::with_base_joint:
        return study.wall.base == dem::Base::joint;
    case Used::with_beam_joint:
        return study.beam.interface == dem::BeamInterface::joint;
    case Used::with_fields:
        return study.uq.spatial == Spatial::correlated;
    }
    return true;
}

} // namespace app
