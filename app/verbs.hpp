#pragma once
/// The verbs of the program: one row for each. Two programs have two tables: verbs.cpp has all,
/// first_verbs.cpp those of one wall, which the launcher builds for a first curve.

#include "app/input/verb.hpp"

#include <span>

namespace app {

[[nodiscard]] std::span<const Verb> verbs();

} // namespace app
