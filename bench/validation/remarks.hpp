#pragma once
/// Meaning of the tables of the validation, in words, with their numbers.

#include "bench/validation/joint_inputs.hpp"
#include "bench/validation/paper_comparison.hpp"

#include <string>
#include <vector>

namespace bench {

/// Levels of studies that the remarks are drawn from.
struct Remarkable {
    OurLevels ours;
    std::vector<Sample> last_falls; ///< of mixed-mode walls, a level each
    LevelStatistics per_joint;      ///< at 0.75 MPa, stratified
    LevelStatistics rigid_limit;    ///< lowest stress, rigid blocks on joints that hardly give
    /// One choice changed each, same samples as ours.same_size.
    std::vector<LevelStatistics> low_load, light_beam, weak_damping, strong_damping,
        combined_damping;
    JointInputs joint_inputs; ///< at 0.75 MPa, 100 walls each
};

[[nodiscard]] std::string remarks_on_tests(const app::Study& study);
[[nodiscard]] std::string remarks_on_differences(const Remarkable& r);

} // namespace bench
