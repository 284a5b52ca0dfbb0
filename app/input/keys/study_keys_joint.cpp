/// Joints: keys of the study file.

#include "app/input/keys/study_key_table.hpp"
#include "app/input/wall/joint_laws.hpp"
#include "app/input/wall/wall_geometry.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

using Closing = dem::Closing;

/// That of joints that close is the share of their normal one under the stress of each wall.
void derive_shear_stiffness(Parameters& p, double course_height)
{
    if (closes(p.joint)) return;
    std::vector<double> kn = p.joint.normal_stiffness;
    for (const double modulus : p.joint.wall_modulus)
        kn.push_back(dem::joint_stiffness(course_height, modulus, p.stone.young_modulus));
    for (double& k : kn) k = dem::shear_stiffness(k, p.stone.poisson_ratio);
    p.joint.shear_stiffness = kn;
}
constexpr Condition kJointsCrush{
    asks<&Study::parameters>([](auto& p) { return p.joint.crushing.strength > 0.0; }),
    "joint.compressive_strength is none"};
constexpr Condition kDryJoints{
    asks<&Study::parameters>([](auto& p) { return !has_mortar(p.joint); }),
    "the joints have mortar and do not wear; remove it", true};
constexpr Condition kJointsWear{
    asks<&Study::parameters>([](auto& p) { return p.joint.wear_length > 0.0; }),
    "joint.wear_length is none"};
/// Whether the friction of any joint that may wear can fall; a draw may be above the residual
/// angle where the mean is not.
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
    asks<&Study::parameters>([](auto& p) { return p.joint.tensile_strength > 0.0; }),
    "joint.tensile_strength is 0"};
constexpr Range kStiffness{'(', 0, 1e6, ']'}; // [GPa/m]

constexpr std::array kClosures = {named("linear", dem::Closure::linear),
                                  named("hyperbolic", dem::Closure::hyperbolic),
                                  named("exponential", dem::Closure::exponential)};
constexpr Condition kDryOrLinear{
    asks<&Study::parameters>([](auto& p) { return !closes(p.joint) || !has_mortar(p.joint); }),
    "the joints have mortar and do not close further; write linear, or remove it", true};
constexpr Condition kJointsClose{
    asks<&Study::parameters>([](auto& p) { return closes(p.joint); }),
    "joint.closure is linear"};
constexpr Condition kFittedClosure{
    asks<&Study::parameters>([](auto& p) { return is_fitted_closure(p.joint); }),
    "joint.wall_modulus gives no law of closure"};
void derive_initial_stiffness(Parameters& p, double course_height)
{
    p.joint.closing.initial_stiffness = closure_fit(p, course_height).initial_stiffness;
}
void derive_maximum_closure(Parameters& p, double course_height)
{
    p.joint.closing.maximum = closure_fit(p, course_height).maximum;
}
void derive_largest_stiffness(Parameters& p, double)
{
    constexpr double kTimes = 100.0; // choice: a limit of numbers, not of joints
    p.joint.closing.stiffest =
        std::min(kTimes * p.joint.closing.initial_stiffness, 1e9 * kStiffness.high);
}
constexpr Condition kWithMortar{
    asks<&Study::parameters>([](auto& p) { return has_mortar(p.joint); }),
    "joints have no mortar"};

// clang-format off
constexpr std::array kJointKeys = {
    Key{.name = "joint.wall_modulus", .kind = Kind::list, .unit = "MPa", .range = {'(', 0, 1e6, ']'},
        .derived = {"or normal_stiffness"},
        .meaning = "one per stress level, gives k_n by Eq. 2 (paper, Table 3); where joints close: of two stresses or more, which give one law",
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
        .meaning = "friction angle of the joints (paper, Table 4)",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::friction_angle>},
    Key{.name = "joint.stiffness_factor", .range = kFactor,
        .varies = Varies::by_joint,
        .meaning = "factor on k_n and k_s of the joints (paper, Table 5)",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::stiffness_factor>},

    Key{.name = "joint.closure", .kind = Kind::word, .names = kClosures, .used = kDryOrLinear,
        .meaning = "k_n of dry joints stays, or grows with pressure: p = k_0 w/(1 - w/V_m) (Bandis, Lumsden and Barton 1983), or k_0 V_m (exp(w/V_m) - 1)",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::closure>},
    Key{.name = "joint.wall_modulus_stress", .kind = Kind::list, .unit = "MPa", .range = {'[', 0, 1000, ']'},
        .used = kFittedClosure,
        .derived = {"load.vertical_stress", [](Study& s) { s.parameters.joint.modulus_stress = s.load.vertical_stress; }},
        .meaning = "vertical stress of each joint.wall_modulus to which one law of closure is fitted",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::modulus_stress>},
    Key{.name = "joint.initial_stiffness", .unit = "GPa/m", .range = kStiffness, .used = kJointsClose,
        .derived = {.rule = "fitted to wall_modulus", .follow = derive_initial_stiffness},
        .varies = Varies::by_joint,
        .meaning = "k_0 of closure: under a vertical stress sigma joints have k_n = k_0 + sigma/V_m; in place of wall_modulus",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::closing, &Closing::initial_stiffness>},
    Key{.name = "joint.maximum_closure", .unit = "mm", .range = {'(', 0, 1000, ']'}, .used = kJointsClose,
        .derived = {.rule = "fitted to wall_modulus", .follow = derive_maximum_closure},
        .varies = Varies::by_joint,
        .meaning = "V_m of closure; in place of wall_modulus",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::closing, &Closing::maximum>},
    Key{.name = "joint.closure_loss", .range = {'[', 0, 1, ')'}, .used = kJointsClose,
        .varies = Varies::by_joint,
        .meaning = "share of the work of closing that a joint does not give back as it opens",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::closing, &Closing::loss>},
    Key{.name = "joint.largest_stiffness", .unit = "GPa/m", .range = kStiffness, .used = kJointsClose,
        .derived = {.rule = "100 initial_stiffness", .follow = derive_largest_stiffness},
        .meaning = "k_n that a joint does not exceed as it closes; a numerical limit, which keeps steps long",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::closing, &Closing::stiffest>},

    Key{.name = "joint.tensile_strength", .unit = "MPa", .range = kStrength,
        .varies = Varies::by_joint,
        .meaning = "tensile strength of the mortar; 0: dry",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::tensile_strength>},
    Key{.name = "joint.cohesion", .unit = "MPa", .range = kStrength,
        .varies = Varies::by_joint,
        .meaning = "cohesion of the mortar; 0: dry. Only friction is left where the mortar is broken",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::cohesion>},
    Key{.name = "joint.fracture_energy", .unit = "N/m", .range = {'[', 0, 1e6, ']'},
        .effect = kBondInTension,
        .varies = Varies::by_joint,
        .meaning = "fracture energy of the mortar, mode I",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::fracture_energy>},
    Key{.name = "joint.envelope", .kind = Kind::word, .names = kEnvelopes, .used = kWithMortar,
        .meaning = "shear strength of the mortar in tension: coulomb, or hyperbolic, which keeps the tensile strength",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::envelope>},
    Key{.name = "joint.shear_fracture_energy", .unit = "N/m", .range = kShearEnergy, .names = kNone,
        .used = kWithMortar,
        .varies = Varies::by_joint,
        .meaning = "fracture energy of the mortar, mode II; none: brittle in shear",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::shear_fracture_energy>},

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
        .meaning = "friction angle of a worn joint, at most the initial one",
        .field = kAt<&Study::parameters, &Parameters::joint, &JointInput::residual_friction_angle>},
};
// clang-format on

} // namespace

std::span<const Key> joint_keys() { return kJointKeys; }

} // namespace app
