/// The wall and its materials: keys of the study file.

#include "app/drawing/drawing.hpp"
#include "app/input/study_key_table.hpp"
#include "app/input/unit_cracks.hpp"
#include "app/input/wall_geometry.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

using dem::Beam;
using dem::CrackParameters;
using dem::Elastic;
using dem::SolverOptions;
using dem::WallGeometry;

/// A shift stands for itself, the other bonds for the numbers from 1 on.
constexpr double kRubble = 5.0;
constexpr double number_of(dem::Bond bond) { return 1.0 + static_cast<double>(bond); }
constexpr std::array kBonds = {named("running", 0.5),
                               named("stack", 0),
                               named("english", number_of(dem::Bond::english)),
                               named("flemish", number_of(dem::Bond::flemish)),
                               named("header", number_of(dem::Bond::header)),
                               named("rubble", kRubble)};

std::vector<double> bond_value(const Study& s)
{
    if (s.geometry.rubble) return {kRubble};
    if (s.wall.bond == dem::Bond::shifted) return {s.wall.bond_offset};
    return {number_of(s.wall.bond)};
}

void set_bond(Study& s, const std::vector<double>& values)
{
    const double value = values.front();
    s.geometry.rubble = value == kRubble;
    const bool other = value >= 1.0 && !s.geometry.rubble;
    s.wall.bond = other ? static_cast<dem::Bond>(value - 1.0) : dem::Bond::shifted;
    if (value < 1.0) s.wall.bond_offset = value;
}

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

void derive_shear_stiffness(Parameters& p, double course_height)
{
    std::vector<double> kn = p.joint.normal_stiffness;
    for (const double modulus : p.joint.wall_modulus)
        kn.push_back(dem::joint_stiffness(course_height, modulus, p.stone.young_modulus));
    for (double& k : kn) k = dem::shear_stiffness(k, p.stone.poisson_ratio);
    p.joint.shear_stiffness = kn;
}

bool rigid_blocks(const Study& s) { return s.discretisation.block_modes == 3; }

constexpr Condition kWithBaseJoint{
    [](const Study& s) { return s.wall.base == dem::Base::joint; },
    "there is no base joint; write wall.base = joint, or remove it", true};
constexpr Condition kWithBeam{[](const Study& s) { return s.beam.present; },
                              "there is no beam; write beam.present = yes, or remove it", true};
constexpr Condition kWithBeamJoint{
    [](const Study& s) { return s.beam.interface == dem::BeamInterface::joint; },
    "there is no beam joint; write beam.interface = joint, or remove it", true};

constexpr Condition kOfDrawing{[](const Study& s) { return !is_picture(s.geometry.file); },
                               "wall.geometry is a picture"};
constexpr Condition kOfPicture{[](const Study& s) { return is_picture(s.geometry.file); },
                               "wall.geometry is no picture"};
constexpr Condition kWhereDrawn{
    [](const Study& s) { return !s.geometry.file.empty() || !s.geometry.outlines.empty(); },
    "the wall is not drawn; write wall.geometry, or remove it", true};
constexpr Condition kBuilt{
    [](const Study& s) { return s.geometry.file.empty() && s.geometry.outlines.empty(); },
    "the wall is drawn, not laid in courses; remove it", true};
constexpr Condition kInCourses{
    in_courses, "the wall is drawn or of rubble, not laid in courses; remove it", true};
constexpr Condition kEqualCourses{
    [](const Study& s) { return kBuilt.holds(s) && s.wall.course_heights.empty(); },
    "the wall is drawn, or wall.course_heights has its courses; remove it", true};
/// Of use to a drawing, but not needed: h of Eq. 2, and the length of whole units.
constexpr Condition kEqualCoursesOrGiven{
    [](const Study& s) {
        return s.wall.course_heights.empty() &&
               (kBuilt.holds(s) || find_entry(s.source, "wall.course_height") != nullptr);
    },
    "wall.course_heights has the heights of the courses; remove it", true};
constexpr Condition kBuiltOrGiven{[](const Study& s) {
    return kBuilt.holds(s) || find_entry(s.source, "wall.unit_length") != nullptr;
}};
constexpr Condition kWithWholeUnits{
    [](const Study& s) { return kBuiltOrGiven.holds(s) && !s.geometry.rubble; },
    "a drawn wall without wall.unit_length, and rubble, have no units known as whole"};
constexpr Condition kWithHeaders{
    [](const Study& s) { return kInCourses.holds(s) && s.wall.bond != dem::Bond::shifted; },
    "there are no headers; write wall.bond = english, flemish or header, or remove it", true};
constexpr Condition kWithShiftedCourses{
    [](const Study& s) { return kInCourses.holds(s) && s.wall.bond == dem::Bond::shifted; },
    "only units of running bond are drawn at random; write wall.bond = running, or remove it",
    true};
constexpr Condition kRandomLayout{
    [](const Study& s) {
        return kBuilt.holds(s) && (s.geometry.rubble || s.wall.length_cov > 0.0);
    },
    "no layout is drawn at random; write wall.bond = rubble, or wall.unit_length_cov, or "
    "remove it",
    true};
constexpr Condition kWithCracks{
    has_cracks,
    "no unit can crack: unit.cracks is none, or a drawn wall has no wall.unit_length"};
using Pattern = dem::CrackPattern;
constexpr Condition kWithCrackRegion{
    [](const Study& s) { return !s.cracks.where.empty(); },
    "unit.cracks holds everywhere; write unit.cracks_where, or remove it", true};
constexpr Condition kWithCrackPattern{[](const Study& s) { return !s.cracks.pattern.empty(); },
                                      "unit.cracks is not given; write it, or remove this",
                                      true};
constexpr Condition kWithVoronoi{[](const Study& s) {
                                     return any_pattern(s, [](const Pattern& p) {
                                         return p.kind == Pattern::Kind::voronoi;
                                     });
                                 },
                                 "no pattern of cracks is voronoi"};
constexpr Condition kSharedStiffness{
    [](const Study& s) {
        return any_pattern(s, [](const Pattern& p) { return dem::shares_stiffness(p); });
    },
    "cracks are parallel vertical lines, whose stiffness is unit.stiffness_ratio"};
constexpr Condition kPaperStiffness{
    [](const Study& s) {
        return any_pattern(s, [](const Pattern& p) {
            return p.kind != Pattern::Kind::none && !dem::shares_stiffness(p);
        });
    },
    "all cracks share the stiffness of their units, by unit.crack_rigidity"};
/// Bonded joints follow the law of cracks too.
constexpr Condition kWithCrackLaw{
    [](const Study& s) { return kWithCracks.holds(s) || has_mortar(s); },
    "no unit can crack and joints have no mortar"};
constexpr std::array kLengthUnits = {named("mm", 1e-3), named("cm", 1e-2), named("m", 1.0),
                                     named("in", 0.0254), named("ft", 0.3048)};

constexpr Condition kWithOpenings{[](const Study& s) { return !s.geometry.openings.empty(); },
                                  "the wall has no openings; write wall.openings, or remove it",
                                  true};
constexpr Condition kWithLintels{[](const Study& s) { return s.wall.lintel_bearing > 0.0; },
                                 "lintel.bearing is 0"};

constexpr Condition kSeveralCourses{[](const Study& s) {
                                        return s.wall.courses > 1 || s.geometry.rubble ||
                                               s.wall.bond != dem::Bond::shifted ||
                                               s.wall.first_course == dem::FirstCourse::shifted;
                                    },
                                    "the wall has one course, which is not shifted"};
constexpr Condition kShiftedCourses{[](const Study& s) {
                                        return s.wall.bond != dem::Bond::shifted ||
                                               s.wall.bond_offset > 0.0;
                                    },
                                    "wall.bond is stack"};
constexpr Condition kMovingFirstCourse{
    [](const Study& s) { return s.wall.base == dem::Base::joint || !rigid_blocks(s); },
    "the first course is rigid and clamped"};
constexpr Condition kWithGravity{[](const Study& s) { return s.load.gravity > 0.0; },
                                 "load.gravity is 0"};
constexpr Condition kTensileCracks{
    [](const Study& s) { return s.parameters.unit.tensile_strength > 0.0; },
    "unit.tensile_strength is 0"};

constexpr std::array kNone = {named("none", 0)};
constexpr Condition kJointsCrush{
    [](const Study& s) { return s.parameters.joint.crushing.strength > 0.0; },
    "joint.compressive_strength is none"};
constexpr Condition kUnitsCrush{
    [](const Study& s) { return s.parameters.unit.crushing.strength > 0.0; },
    "unit.compressive_strength is none"};

constexpr Condition kDryJoints{[](const Study& s) { return !has_mortar(s); },
                               "joints have mortar, whose law knows no wear; remove it", true};
constexpr Condition kJointsWear{
    [](const Study& s) { return s.parameters.joint.wear_length > 0.0; },
    "joint.wear_length is none"};
/// Of any joint that may wear; a draw may be above the residual angle where the mean is not.
bool friction_can_fall(const Study& s)
{
    const Parameters& p = s.parameters;
    const double left = p.joint.residual_friction_angle;
    const bool drawn =
        find_entry(s.source, "joint.residual_friction_angle") != nullptr &&
        std::ranges::any_of(s.random, [](const RandomInput& r) {
            return r.key == "joint.friction_angle" || r.key == "joint.residual_friction_angle";
        });
    return drawn || left < p.joint.friction_angle ||
           (kWithBaseJoint.holds(s) && left < p.base_friction_angle) ||
           (kWithBeam.holds(s) && kWithBeamJoint.holds(s) && left < p.beam_friction_angle);
}
constexpr Condition kFrictionFalls{
    friction_can_fall, "no joint has a friction above joint.residual_friction_angle"};

constexpr Condition kBondInTension{
    [](const Study& s) { return s.parameters.joint.tensile_strength > 0.0; },
    "joint.tensile_strength is 0"};

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
    Key{.name = "wall.geometry", .kind = Kind::text,
        .meaning = "a drawing of the blocks (.dxf, .json, .svg) or a picture of the stones (.png), in place of courses; from the folder of the study",
        .field = kAt<&Study::geometry, &GeometryInput::file>},
    Key{.name = "wall.outlines", .kind = Kind::text,
        .meaning = "the same as text: corners x z in metres, counter-clockwise, between commas; blocks between semicolons",
        .field = kAt<&Study::geometry, &GeometryInput::outlines>},
    Key{.name = "wall.length_unit", .kind = Kind::word, .names = kLengthUnits, .used = kOfFile,
        .effect = kOfDrawing,
        .meaning = "of the drawing",
        .field = kAt<&Study::geometry, &GeometryInput::length_unit>},
    Key{.name = "wall.snap", .unit = "mm", .range = {'[', 0, 100, ']'}, .used = kOfFile,
        .effect = kOfDrawing,
        .meaning = "gaps and overlaps of a drawing up to this are closed",
        .field = kAt<&Study::geometry, &GeometryInput::snap>},
    Key{.name = "wall.picture_width", .unit = "m", .range = {'[', 0, 100, ']'}, .used = kOfFile,
        .effect = kOfPicture,
        .meaning = "of the picture from edge to edge; must be given",
        .field = kAt<&Study::geometry, &GeometryInput::picture_width>},
    Key{.name = "wall.picture_height", .unit = "m", .range = {'[', 0, 100, ']'}, .used = kOfFile,
        .effect = kOfPicture,
        .meaning = "of the picture from edge to edge; must be given",
        .field = kAt<&Study::geometry, &GeometryInput::picture_height>},
    Key{.name = "wall.simplify", .unit = "mm", .range = {'[', 0, 1000, ']'}, .used = kOfFile,
        .effect = kOfPicture,
        .meaning = "how far an outline may be from the stone's in the picture",
        .field = kAt<&Study::geometry, &GeometryInput::simplify>},
    Key{.name = "wall.layer_stones", .kind = Kind::text, .used = kWhereDrawn,
        .meaning = "stone of layers that is not the wall's: lintel: 30 GPa, 0.2, 2500 kg/m3; ...",
        .field = kAt<&Study::geometry, &GeometryInput::layer_stones>},
    Key{.name = "wall.length", .unit = "m", .range = kLength, .used = kBuilt, .example = "1.00 m",
        .meaning = "along the push",
        .field = kAt<&Study::wall, &WallGeometry::length>},
    Key{.name = "wall.course_heights", .kind = Kind::list, .unit = "m", .range = kHeight, .used = kInCourses,
        .derived = {"all wall.course_height"},
        .meaning = "of each course, from the bottom, in place of courses and course_height; h of Eq. 2 is their mean",
        .field = kAt<&Study::wall, &WallGeometry::course_heights>},
    Key{.name = "wall.courses", .kind = Kind::count, .range = {'[', 1, 1000, ']'}, .used = kEqualCourses, .example = "10",
        .meaning = "number of courses; of rubble: mean number of stones one above the other",
        .field = kAt<&Study::wall, &WallGeometry::courses>},
    Key{.name = "wall.course_height", .unit = "m", .range = kHeight, .used = kEqualCoursesOrGiven, .example = "0.10 m",
        .meaning = "height of a course, h of Eq. 2; of rubble: of a mean stone",
        .field = kAt<&Study::wall, &WallGeometry::course_height>},
    Key{.name = "wall.unit_length", .unit = "m", .range = kLength, .used = kBuiltOrGiven, .example = "0.20 m",
        .meaning = "length of a whole unit; of rubble: of a mean stone",
        .field = kAt<&Study::wall, &WallGeometry::unit_length>},
    Key{.name = "wall.thickness", .unit = "m", .range = kLength, .example = "0.20 m",
        .meaning = "of the wall, out of plane",
        .field = kAt<&Study::wall, &WallGeometry::thickness>},
    Key{.name = "wall.bond", .range = {'[', 0, 1, ')'}, .names = kBonds,
        .used = kBuilt, .effect = kSeveralCourses,
        .meaning = "shift of every second course in unit lengths (running 0.5, stack 0); english, flemish, header; or random stones: rubble",
        .field = {bond_value, set_bond}},
    Key{.name = "wall.header_length", .unit = "m", .range = kLength, .used = kWithHeaders,
        .derived = {"half of wall.unit_length", [](Study& s) { s.wall.header_length = 0.5 * s.wall.unit_length; }},
        .meaning = "along the wall, of units that lie across it",
        .field = kAt<&Study::wall, &WallGeometry::header_length>},
    Key{.name = "wall.unit_length_cov", .range = {'[', 0, 1, ')'}, .used = kWithShiftedCourses,
        .meaning = "coefficient of variation of the lengths of whole units, whose head joints move to either side",
        .field = kAt<&Study::wall, &WallGeometry::length_cov>},
    Key{.name = "wall.seed", .kind = Kind::count, .range = {'[', 0, 1e9, ']'}, .used = kRandomLayout,
        .meaning = "of random lengths of units, or of rubble",
        .field = kAt<&Study::wall, &WallGeometry::seed>},
    Key{.name = "wall.layouts", .kind = Kind::count, .range = {'[', 1, 1e6, ']'}, .used = kRandomLayout,
        .verbs = "push study sample",
        .meaning = "number of random layouts, of the seeds wall.seed, wall.seed + 1, ...: the samples of a study take them in turn",
        .field = kAt<&Study::geometry, &GeometryInput::layouts>},
    Key{.name = "wall.first_course", .kind = Kind::word, .names = kFirstCourses,
        .used = kInCourses, .effect = kShiftedCourses,
        .meaning = "bottom course starts with a whole unit or with the shifted piece",
        .field = kAt<&Study::wall, &WallGeometry::first_course>},
    Key{.name = "wall.unit_cracks", .kind = Kind::word, .names = kYesNo,
        .used = kWithWholeUnits,
        .meaning = "a potential crack at mid-length of each whole unit (paper, Fig. 2)",
        .field = kAt<&Study::cracks, &CrackInput::in_units>},
    Key{.name = "wall.openings", .kind = Kind::text, .used = kInCourses,
        .meaning = "doors and windows as x, z, width, height between courses: 0.4 m, 0 m, 0.6 m, 1.2 m; ...",
        .field = kAt<&Study::geometry, &GeometryInput::openings>},
    Key{.name = "wall.base", .kind = Kind::word, .names = kBases,
        .meaning = "bottom face clamped (paper, section 3), or on a dry joint",
        .field = kAt<&Study::wall, &WallGeometry::base>},
    Key{.name = "wall.toe", .kind = Kind::word, .names = kToes,
        .used = kInCourses, .effect = kMovingFirstCourse,
        .meaning = "toe side of the first course held sideways (paper, section 3)",
        .field = kAt<&Study::wall, &WallGeometry::toe>},

    Key{.name = "stone.young_modulus", .unit = "GPa", .range = kModulus,        .example = "15.5 GPa",
        .varies = Varies::by_wall,
        .meaning = "E_stone of Eq. 2",
        .field = kAt<&Study::parameters, &Parameters::stone, &Elastic::young_modulus>},
    Key{.name = "stone.poisson_ratio", .range = kPoisson,        .example = "0.2",
        .fixed_because = "because the walls of a study share the deformation modes of their blocks (through the "
                         "blocks, 0.1 to 0.3 moves the stiffness of the paper's wall by 0.6 % and its peak by 0.1 %)",
        .meaning = "also of k_s = k_n / (2 (1 + nu)) (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::stone, &Elastic::poisson_ratio>},
    Key{.name = "stone.density", .unit = "kg/m3", .range = kDensity, .effect = kWithGravity,
        .example = "2300 kg/m3",
        .varies = Varies::by_wall,
        .meaning = "self-weight of the wall",
        .field = kAt<&Study::parameters, &Parameters::stone, &Elastic::density>},

    Key{.name = "lintel.bearing", .unit = "m", .range = {'[', 0, 10, ']'}, .used = kWithOpenings,
        .derived = {"half of wall.unit_length", [](Study& s) { s.wall.lintel_bearing = 0.5 * s.wall.unit_length; }},
        .meaning = "how far a lintel, one course high, reaches over either side of its opening; 0: no lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel_bearing>},
    Key{.name = "lintel.young_modulus", .unit = "GPa", .range = kModulus, .used = kWithOpenings,
        .effect = kWithLintels,
        .derived = {"stone.young_modulus", [](Study& s) { s.wall.lintel.young_modulus = s.parameters.stone.young_modulus; }},
        .meaning = "of the lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel, &Elastic::young_modulus>},
    Key{.name = "lintel.poisson_ratio", .range = kPoisson, .used = kWithOpenings,
        .effect = kWithLintels,
        .derived = {"stone.poisson_ratio", [](Study& s) { s.wall.lintel.poisson_ratio = s.parameters.stone.poisson_ratio; }},
        .meaning = "of the lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel, &Elastic::poisson_ratio>},
    Key{.name = "lintel.density", .unit = "kg/m3", .range = kDensity, .used = kWithOpenings,
        .effect = kWithLintels,
        .derived = {"stone.density", [](Study& s) { s.wall.lintel.density = s.parameters.stone.density; }},
        .meaning = "of the lintels",
        .field = kAt<&Study::wall, &WallGeometry::lintel, &Elastic::density>},

    Key{.name = "joint.wall_modulus", .kind = Kind::list, .unit = "MPa", .range = {'(', 0, 1e6, ']'},
        .derived = {"or normal_stiffness"},
        .meaning = "one per stress level, gives k_n by Eq. 2 (paper, Table 3)",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::wall_modulus>},
    Key{.name = "joint.normal_stiffness", .kind = Kind::list, .unit = "GPa/m", .range = kStiffness,
        .derived = {"from wall_modulus"},
        .meaning = "k_n, one or one per stress level; in place of wall_modulus",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::normal_stiffness>},
    Key{.name = "joint.shear_stiffness", .kind = Kind::list, .unit = "GPa/m", .range = kStiffness,
        .derived = {.rule = "k_n / (2 (1 + nu))", .follow = derive_shear_stiffness},
        .meaning = "k_s, one or one per stress level (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::shear_stiffness>},
    Key{.name = "joint.friction_angle", .unit = "deg", .range = kAngle, .example = "31.8 deg",
        .varies = Varies::by_joint,
        .meaning = "of the joints (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::friction_angle>},
    Key{.name = "joint.stiffness_factor", .range = kFactor,
        .varies = Varies::by_joint,
        .meaning = "on k_n and k_s of the joints (paper, Table 5)",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::stiffness_factor>},

    Key{.name = "joint.tensile_strength", .unit = "MPa", .range = kStrength,
        .varies = Varies::by_joint,
        .meaning = "of mortar; 0: dry",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::tensile_strength>},
    Key{.name = "joint.cohesion", .unit = "MPa", .range = kStrength,
        .varies = Varies::by_joint,
        .meaning = "of mortar; 0: dry. Friction alone is left where it is broken",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::cohesion>},
    Key{.name = "joint.fracture_energy", .unit = "N/m", .range = {'[', 0, 1e6, ']'},
        .effect = kBondInTension,
        .varies = Varies::by_joint,
        .meaning = "of mortar, mode I",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::fracture_energy>},

    Key{.name = "joint.compressive_strength", .unit = "MPa", .range = {'(', 0, 10000, ']'}, .names = kNone,
        .varies = Varies::by_joint,
        .meaning = "f_c of the faces of joints, at the base and at a beam on a joint too; none: they do not crush",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::crushing, &dem::Crushing::strength>},
    Key{.name = "joint.crushing_energy", .unit = "N/m", .range = {'(', 0, 1e9, ']'}, .names = kNone,
        .effect = kJointsCrush,
        .varies = Varies::by_joint,
        .meaning = "G_c from f_c to nothing; none: the strength stays",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::crushing, &dem::Crushing::energy>},

    Key{.name = "joint.wear_length", .unit = "mm", .range = {'(', 0, 10000, ']'}, .names = kNone,
        .used = kDryJoints, .effect = kFrictionFalls,
        .varies = Varies::by_joint,
        .meaning = "slip that leaves 1/e of the difference to the residual friction, at the base and at a beam on a joint too; none: joints do not wear",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::wear_length>},
    Key{.name = "joint.residual_friction_angle", .unit = "deg", .range = kAngle,
        .used = kDryJoints, .effect = kJointsWear,
        .derived = {.rule = "friction_angle", .follow = [](Parameters& p, double) { p.joint.residual_friction_angle = p.joint.friction_angle; }},
        .varies = Varies::by_joint,
        .meaning = "of a worn joint, at most the initial one",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::residual_friction_angle>},

    Key{.name = "unit.cracks", .kind = Kind::text,
        .derived = {"mid, or none where wall.unit_cracks is no"},
        .meaning = "where units may crack: none, mid (paper), thirds, grid(4, 4), diagonals, voronoi(40 mm)",
        .field = kAt<&Study::cracks, &CrackInput::pattern>},
    Key{.name = "unit.cracks_where", .kind = Kind::text, .used = kWithCrackPattern,
        .derived = {"everywhere"},
        .meaning = "units whose middle lies in x, z, width, height, or in several such boxes: 0.5 m, 0 m, 0.5 m, 0.4 m; ...; toe: the lower 40 % of the half that the wall is pushed towards; needed: those that a coarse push finds near their strength, the others have none",
        .field = kAt<&Study::cracks, &CrackInput::where>},
    Key{.name = "unit.cracks_elsewhere", .kind = Kind::text, .used = kWithCrackRegion,
        .derived = {"mid"},
        .meaning = "cracks of the other units",
        .field = kAt<&Study::cracks, &CrackInput::elsewhere>},
    Key{.name = "unit.cracks_seed", .kind = Kind::count, .range = {'[', 0, 1e9, ']'},
        .used = kWithCrackPattern, .effect = kWithVoronoi,
        .meaning = "of the cells of voronoi",
        .field = kAt<&Study::wall, &WallGeometry::cracks, &dem::UnitCracks::seed>},
    Key{.name = "unit.crack_rigidity", .range = {'(', 1, 1000, ']'},
        .used = kWithCrackPattern, .effect = kSharedStiffness,
        .meaning = "k_n of a crack over the stiffness of the stone between two cracks, where pieces have cracks on all sides; the stone is as much stiffer as keeps that of the unit",
        .field = kAt<&Study::wall, &WallGeometry::cracks, &dem::UnitCracks::rigidity>},
    Key{.name = "unit.stiffness_ratio", .range = {'(', 0, 1e6, ']'}, .used = kWithCracks,
        .effect = kPaperStiffness,
        .varies = Varies::by_crack,
        .meaning = "xi = k_n of a crack / k_n of a joint (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::stiffness_ratio>},
    Key{.name = "unit.tensile_strength", .unit = "MPa", .range = kStrength,
        .used = kWithCracks, .example = "3.7 MPa",
        .varies = Varies::by_crack,
        .meaning = "f_T of the units (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::tensile_strength>},
    Key{.name = "unit.cohesion", .unit = "MPa", .range = kStrength, .used = kWithCracks,
        .derived = {.rule = "tensile_strength", .follow = [](Parameters& p, double) { p.unit.cohesion = p.unit.tensile_strength; }},
        .varies = Varies::by_crack,
        .meaning = "initial (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::cohesion>},
    Key{.name = "unit.residual_cohesion", .unit = "MPa", .range = kStrength,
        .used = kWithCracks,
        .varies = Varies::by_crack,
        .meaning = "at most the initial one",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::residual_cohesion>},
    Key{.name = "unit.fracture_energy", .unit = "N/m", .range = {'[', 0, 1e6, ']'},
        .used = kWithCracks, .effect = kTensileCracks,
        .example = "110 N/m",
        .varies = Varies::by_crack,
        .meaning = "mode I (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::fracture_energy>},
    Key{.name = "unit.friction_angle", .unit = "deg", .range = kAngle, .used = kWithCracks,
        .example = "35 deg",
        .varies = Varies::by_crack,
        .meaning = "initial, of a crack (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::friction_angle>},
    Key{.name = "unit.residual_friction_angle", .unit = "deg", .range = kAngle,
        .used = kWithCracks,
        .derived = {.rule = "friction_angle", .follow = [](Parameters& p, double) { p.unit.residual_friction_angle = p.unit.friction_angle; }},
        .varies = Varies::by_crack,
        .meaning = "at most the initial one (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::residual_friction_angle>},
    Key{.name = "unit.stiffness_factor", .range = kFactor, .used = kWithCracks,
        .varies = Varies::by_crack,
        .meaning = "on k_n and k_s of the cracks (paper, Table 5)",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::stiffness_factor>},
    Key{.name = "unit.compressive_strength", .unit = "MPa", .range = {'(', 0, 10000, ']'}, .names = kNone,
        .used = kWithCracks,
        .varies = Varies::by_crack,
        .meaning = "f_c along the cracks of units; a crack that crushes has no bond left; none: they do not crush",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::crushing, &dem::Crushing::strength>},
    Key{.name = "unit.crushing_energy", .unit = "N/m", .range = {'(', 0, 1e9, ']'}, .names = kNone,
        .used = kWithCracks, .effect = kUnitsCrush,
        .varies = Varies::by_crack,
        .meaning = "G_c from f_c to nothing; none: the strength stays",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::crushing, &dem::Crushing::energy>},
    Key{.name = "unit.contact_law", .kind = Kind::word, .names = kLaws, .used = kWithCrackLaw,
        .meaning = "damage of tension and shear together (paper, Table 2) or apart (Fig. 7)",
        .field = kAt<&Study::solver, &SolverOptions::law>},
    Key{.name = "unit.tension_reduces_shear", .kind = Kind::word, .names = kYesNo,
        .used = kWithCracks,
        .meaning = "tau_max = c - sigma tan(theta) in tension too (paper, Table 2, step 5), or c there",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::tension_reduces_shear>},
    Key{.name = "unit.snap_back", .kind = Kind::word, .names = kSnapBacks,
        .used = kWithCracks,
        .effect = kTensileCracks,
        .meaning = "where f_T > sqrt(2 G k_n) a crack breaks at f_T, or is weakened to that value",
        .field = kAt<&Study::parameters, &Parameters::unit, &CrackParameters::snap_back>},
    Key{.name = "unit.unloading", .kind = Kind::word, .names = kUnloadings,
        .used = kWithCrackLaw,
        .meaning = "an open crack closes to the origin, or with k_n (paper, Table 1) and stays propped",
        .field = kAt<&Study::solver, &SolverOptions::unloading>},

    Key{.name = "beam.present", .kind = Kind::word, .names = kYesNo,
        .meaning = "no: a wall alone, pushed by load.pattern = body",
        .field = kAt<&Study::beam, &Beam::present>},
    Key{.name = "beam.height", .unit = "m", .range = kHeight, .used = kWithBeam, .example = "0.10 m",
        .meaning = "of the loading beam on the wall",
        .field = kAt<&Study::beam, &Beam::height>},
    Key{.name = "beam.young_modulus", .unit = "GPa", .range = kModulus, .used = kWithBeam, .example = "30 GPa",
        .meaning = "of the loading beam",
        .field = kAt<&Study::beam, &Beam::material, &Elastic::young_modulus>},
    Key{.name = "beam.poisson_ratio", .range = kPoisson,
        .used = kWithBeam,
        .meaning = "of the loading beam; concrete",
        .field = kAt<&Study::beam, &Beam::material, &Elastic::poisson_ratio>},
    Key{.name = "beam.density", .unit = "kg/m3", .range = kDensity,
        .used = kWithBeam, .effect = kWithGravity,
        .example = "2400 kg/m3",
        .meaning = "weight of the loading beam",
        .field = kAt<&Study::beam, &Beam::material, &Elastic::density>},
    Key{.name = "beam.interface", .kind = Kind::word, .names = kInterfaces,
        .used = kWithBeam,
        .meaning = "beam glued to the top course, or on a dry joint",
        .field = kAt<&Study::beam, &Beam::interface>},
    Key{.name = "beam.friction_angle", .unit = "deg", .range = kAngle,
        .used = kWithBeamJoint,
        .derived = {.rule = "joint.friction_angle", .follow = [](Parameters& p, double) { p.beam_friction_angle = p.joint.friction_angle; }},
        .varies = Varies::by_wall,
        .meaning = "under the beam, only with interface = joint",
        .field = kAt<&Study::parameters, &Parameters::beam_friction_angle>},
    Key{.name = "beam.rotation", .kind = Kind::word, .names = kRotations,
        .used = kWithBeam,
        .meaning = "the beam may turn, or stays level",
        .field = kAt<&Study::beam, &Beam::rotation>},

    Key{.name = "base.friction_angle", .unit = "deg", .range = kAngle,
        .used = kWithBaseJoint,
        .derived = {.rule = "joint.friction_angle", .follow = [](Parameters& p, double) { p.base_friction_angle = p.joint.friction_angle; }},
        .varies = Varies::by_wall,
        .meaning = "under the first course, only with wall.base = joint",
        .field = kAt<&Study::parameters, &Parameters::base_friction_angle>},
};
// clang-format on

} // namespace

std::span<const Key> wall_keys() { return kKeys; }

} // namespace app
