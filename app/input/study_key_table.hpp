#pragma once
/// Parts of the table of keys of the study file.

#include "app/input/study_keys.hpp"

#include <array>
#include <span>
#include <string_view>

namespace app {

/// A word of a key, and what it stands for.
constexpr Named named(std::string_view word, auto value)
{
    return {word, static_cast<double>(value)};
}

inline constexpr std::array kYesNo = {named("yes", true), named("no", false)};

/// Keys that say how a file is read.
inline constexpr Condition kOfFile{[](const Study& s) { return !s.geometry.file.empty(); },
                                   "there is no wall.geometry to read; remove it", true};

[[nodiscard]] std::span<const Key> wall_keys();   ///< wall, stone, joint, unit, beam, base
[[nodiscard]] std::span<const Key> solver_keys(); ///< load, solver, output
[[nodiscard]] std::span<const Key> random_keys(); ///< uq, reliability, fragility

} // namespace app
