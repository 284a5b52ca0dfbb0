#pragma once
/// Input and result files of an external program (docs/external_program.md).

#include "uq/reliability/limit_state/external_program.hpp"

#include <cstdint>
#include <string>

namespace uq {

/// {"sample": 17, "parameters": {"name": value, ...}}; numbers read back to the bit.
[[nodiscard]] std::string input_text(std::uint64_t sample,
                                     const std::vector<std::string>& parameters,
                                     const Eigen::VectorXd& x);

struct ProgramResult {
    Eigen::VectorXd y;     ///< in the order of the names; empty if it failed
    std::string failure;   ///< why there are no numbers
    bool declared = false; ///< the program itself says that it failed
};

/// {"responses": {"name": value, ...}} or {"failure": "reason"}; other keys are let be.
[[nodiscard]] ProgramResult read_result(const std::filesystem::path& file,
                                        const std::vector<std::string>& responses);

/// The last `lines` lines of a file, joined by " | "; at most 2000 characters.
[[nodiscard]] std::string last_lines(const std::filesystem::path& file, int lines);

} // namespace uq
