#pragma once
/// Other programs that make files of ours: found by their names, and never needed.

#include <string>
#include <vector>

namespace app {

/// Whether an exit code says that there is no such program.
[[nodiscard]] bool is_missing(int code);

/// Exit code of a program whose output is thrown away.
/// @param words its name and its arguments
[[nodiscard]] int run_program(std::vector<std::string> words);

} // namespace app
