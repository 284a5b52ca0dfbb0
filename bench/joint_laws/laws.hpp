#pragma once
/// The laws of joints and units that docs/joint_laws.md compares: names of the files that
/// bench/joint_laws.sh writes, and words.

#include <array>
#include <string_view>

namespace bench {

struct JointLaw {
    std::string_view file; ///< "random/paper.h5" is its study of random walls
    std::string_view name; ///< in tables
    std::string_view what; ///< what differs from the paper's laws
};

/// The last is that of configs/closure.ini.
inline constexpr std::array kJointLaws = {
    JointLaw{"paper", "paper",
             "constant stiffness by the stress, Coulomb's line, units brittle in shear"},
    JointLaw{"hyperbolic_closure", "hyperbolic closure", "`joint.closure = hyperbolic`"},
    JointLaw{"exponential_closure", "exponential closure", "`joint.closure = exponential`"},
    JointLaw{"envelope", "envelope", "`unit.envelope = hyperbolic`"},
    JointLaw{"shear_energy", "energy in shear", "`unit.shear_fracture_energy = 1100 N/m`"},
    JointLaw{"all_hyperbolic", "all, hyperbolic", "the last two and hyperbolic closure"},
    JointLaw{"all_exponential", "all, exponential",
             "the same with exponential closure: `configs/closure.ini`"}};

constexpr std::string_view kPaperLaw = kJointLaws[0].file, kAllLaws = kJointLaws[5].file,
                           kAllExponential = kJointLaws[6].file;

/// Name in tables of a law; "" if there is none.
[[nodiscard]] constexpr std::string_view name_of(std::string_view file)
{
    for (const JointLaw& law : kJointLaws)
        if (law.file == file) return law.name;
    return {};
}

} // namespace bench
