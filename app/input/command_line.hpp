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

/// The help of one verb (its options, and the keys of a study that it reads), of one key, or
/// all verbs, keys and options that speak of a word.
/// @param topic a verb, a key with or without its section, or a word; empty: the program
/// @throws ConfigError if nothing speaks of it
[[nodiscard]] std::string help_text(std::span<const Verb> verbs, std::string_view topic);

} // namespace app
