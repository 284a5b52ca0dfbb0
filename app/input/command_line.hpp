#pragma once
/// The command line: `drystone VERB WORDS [options]`.

#include "app/input/verbs.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Part `index` (from 0) of `count`.
struct Shard {
    int index = 0, count = 1;
};

struct Command {
    Verb verb = Verb::help;
    std::string topic;                  ///< the verb that help is about; empty: the program
    std::string study;                  ///< first word: path of the study file
    std::vector<std::string> words;     ///< all words after the verb
    std::string out;                    ///< output directory or file; it may not exist yet
    std::vector<std::string> overrides; ///< section.key=value, in order
    int threads = 1;                    ///< >= 1
    bool quiet = false;                 ///< no progress
    std::optional<int> sample;          ///< of a study, >= 0
    std::string level; ///< vertical stress of that sample as written; empty: the only one
    Shard shard;
    std::string script;             ///< write a job array to this file instead of running
    bool rerun_failed = false;      ///< run failed walls again
    bool report = false;            ///< study: then its tables and its page
    bool partial = false;           ///< merge although walls are missing
    std::vector<std::string> drift; ///< fragility: columns of a table
    std::string censored, group;    ///< fragility: columns of a table; empty: none
    std::optional<int> walls;       ///< report: how many can be looked at, >= 0
};

/// @param arguments without the name of the program
/// @throws ConfigError that names the option; nothing has been written then
[[nodiscard]] Command parse_command_line(const std::vector<std::string>& arguments);

/// @param topic a verb, or empty for the program
[[nodiscard]] std::string help_text(std::string_view topic);

} // namespace app
