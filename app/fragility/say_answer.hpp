#pragma once
/// The answer of a study, as a terminal gets it when all its walls are pushed.

#include <string>

namespace app {

/// Prints the table `answer` of the walls in a file.
/// @throws Interrupted, StoreError
void say_answer(const std::string& file, bool quiet);

} // namespace app
