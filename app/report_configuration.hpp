#pragma once
/// The study of a stored file, from its configuration.

#include "app/study.hpp"

#include <string>
#include <string_view>

namespace app {

/// The configuration without the defaults that follow from other values: as written there they would
/// be numbers given, and no longer follow what is drawn for a wall. Without the sections that say
/// nothing of a wall (fragility, reliability), too.
[[nodiscard]] std::string without_derived(std::string_view configuration);

/// The study that wrote the configuration (effective_configuration).
/// @throws ConfigError if this version does not read it
[[nodiscard]] Study read_configuration(const std::string& name, std::string_view configuration);

} // namespace app
