#pragma once
/// The verbs of the program: one row for each.

#include "app/input/verb.hpp"

#include <span>

namespace app {

[[nodiscard]] std::span<const Verb> verbs();

} // namespace app
