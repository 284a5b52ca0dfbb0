#pragma once
/// The options of the command line: one row for each.

#include "app/input/command.hpp"
#include "app/input/keys/verb_set.hpp"

#include <boost/program_options/options_description.hpp>

#include <span>
#include <string>
#include <string_view>

namespace app {

struct Option {
    std::string name;       ///< without its hyphens
    std::string value_name; ///< as shown in the help; empty: the option takes no value
    std::string meaning;    ///< one line
    VerbSet verbs;          ///< that take it; empty: all
    bool repeats = false;   ///< may be given more than once
    /// @throws BadValue if the value is not one of this option
    void (*apply)(Command& command, const std::string& value) = nullptr;
};

[[nodiscard]] int default_threads(); ///< all of this machine, >= 1

[[nodiscard]] std::span<const Option> options();

/// nullptr if there is no option of this name.
[[nodiscard]] const Option* find_option(std::string_view name);

[[nodiscard]] bool takes(const Verb& verb, const Option& option);

/// The options of a verb, or of all verbs, for Boost to read and to list.
/// @param verb nullptr: of all
[[nodiscard]] boost::program_options::options_description described(const Verb* verb);

} // namespace app
