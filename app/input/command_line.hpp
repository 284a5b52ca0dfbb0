#pragma once
/// The command line: `drystone VERB WORDS [options]`.

#include "app/input/verb.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// @param verbs all verbs; one of them is called help, one version
/// @param arguments without the name of the program
/// @throws ConfigError that names the option; nothing has been written then
[[nodiscard]] Command parse_command_line(std::span<const Verb> verbs,
                                         const std::vector<std::string>& arguments);

/// The help of one verb: its options, and the keys of a study that it reads.
/// @param topic a verb; empty: the program
/// @throws ConfigError if there is no such verb
[[nodiscard]] std::string help_text(std::span<const Verb> verbs, std::string_view topic);

} // namespace app
