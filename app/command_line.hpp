#pragma once
/// The command line: `drystone VERB STUDY.ini [options]`.

#include <string>
#include <string_view>
#include <vector>

namespace app {

enum class Verb { help, version, push };

struct Command {
    Verb verb = Verb::help;
    std::string topic;                  ///< the verb that help is about; empty: the program
    std::string study;                  ///< path of the study file
    std::string out;                    ///< output directory; it may not exist yet
    std::vector<std::string> overrides; ///< section.key=value, in order
    int threads = 1;                    ///< >= 1
    bool quiet = false;                 ///< no progress
};

/// @param arguments without the name of the program
/// @throws ConfigError that names the option; nothing has been written then
[[nodiscard]] Command parse_command_line(const std::vector<std::string>& arguments);

/// @param topic a verb, or empty for the program
[[nodiscard]] std::string help_text(std::string_view topic);

} // namespace app
