#pragma once
/// Which input makes values per joint lower the force.

#include "app/output/table.hpp"
#include "bench/validation/level_statistics.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bench {

struct JointInput {
    const char* name;
    LevelStatistics walls;
};

/// The five inputs per joint under 0.75 MPa, one at a time and together, from `work`/joint.
[[nodiscard]] std::vector<JointInput> joint_inputs(const std::filesystem::path& work);

[[nodiscard]] app::Table joint_inputs_table(const std::vector<JointInput>& inputs);

/// The same in words.
[[nodiscard]] std::string remark_on_joint_inputs(const std::vector<JointInput>& inputs);

} // namespace bench
