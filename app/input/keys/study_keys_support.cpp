/// The beam above and the joint below: keys of the study file.

#include "app/input/keys/study_key_table.hpp"

#include <array>

namespace app {
namespace {

using dem::Beam;
using dem::Elastic;

constexpr std::array kInterfaces = {named("tied", dem::BeamInterface::tied),
                                    named("joint", dem::BeamInterface::joint)};
constexpr std::array kRotations = {named("free", dem::BeamRotation::free),
                                   named("fixed", dem::BeamRotation::fixed)};

// clang-format off
constexpr std::array kSupportKeys = {
    Key{.name = "beam.present", .kind = Kind::word, .names = kYesNo,
        .meaning = "no: a wall alone, pushed by load.pattern = body",
        .field = kAt<&Study::beam, &Beam::present>},
    Key{.name = "beam.height", .unit = "m", .range = kHeight, .used = kWithBeam, .example = "0.10 m",
        .meaning = "height of the loading beam on the wall",
        .field = kAt<&Study::beam, &Beam::height>},
    Key{.name = "beam.young_modulus", .unit = "GPa", .range = kModulus, .used = kWithBeam, .example = "30 GPa",
        .meaning = "Young's modulus of the loading beam",
        .field = kAt<&Study::beam, &Beam::material, &Elastic::young_modulus>},
    Key{.name = "beam.poisson_ratio", .range = kPoisson,
        .used = kWithBeam,
        .meaning = "Poisson's ratio of the loading beam; the default is that of concrete",
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
        .meaning = "friction angle under the beam, only with interface = joint",
        .field = kAt<&Study::parameters, &Parameters::beam_friction_angle>},
    Key{.name = "beam.rotation", .kind = Kind::word, .names = kRotations,
        .used = kWithBeam,
        .meaning = "the beam may turn, or stays level",
        .field = kAt<&Study::beam, &Beam::rotation>},

    Key{.name = "base.friction_angle", .unit = "deg", .range = kAngle,
        .used = kWithBaseJoint,
        .derived = {.rule = "joint.friction_angle", .follow = [](Parameters& p, double) { p.base_friction_angle = p.joint.friction_angle; }},
        .varies = Varies::by_wall,
        .meaning = "friction angle under the first course, only with wall.base = joint",
        .field = kAt<&Study::parameters, &Parameters::base_friction_angle>},
};
// clang-format on

} // namespace

std::span<const Key> support_keys() { return kSupportKeys; }

} // namespace app
