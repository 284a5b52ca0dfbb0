#pragma once
/// Which input makes values per joint lower the force.

#include "app/output/table/table.hpp"
#include "bench/validation/level_statistics.hpp"

#include <filesystem>

namespace bench {

/// Walls under 0.75 MPa with values per joint (bench/validation.sh): of one input each, the
/// others at their means.
struct JointInputs {
    LevelStatistics none; ///< one wall of mean values
    LevelStatistics joint_friction, joint_stiffness, unit_strength, unit_friction,
        unit_stiffness;
    LevelStatistics all, more_scatter; ///< all five; with COV 0.30 of the friction of joints
    LevelStatistics by_course;         ///< all five, each the same along a course
};

/// @throws std::runtime_error naming a study that is missing
[[nodiscard]] JointInputs joint_inputs(const std::filesystem::path& work);

[[nodiscard]] app::Table joint_inputs_table(const JointInputs& inputs);

} // namespace bench
