#pragma once
/// A verb of the command line. The table of all verbs is app/verbs.cpp.

#include "app/input/command.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace app {

/// Kind of place that --out names.
enum class OutKind {
    folder, ///< a folder, by default runs/<name of the study>, or beside the FILE.h5 that is read
    file,   ///< a file, by default the same with the extension of the verb
    first_word, ///< the verb has no --out: its first word names the file
    none        ///< the verb writes no file
};

/// Sections of a study file that make a wall and the numbers read off it.
inline constexpr std::string_view kWallSections =
    "wall lintel stone joint unit beam base load solver output uq fragility";

/// One row of the table of verbs.
struct Verb {
    std::string_view name;
    std::string_view words = "";   ///< shown in usage lines: "STUDY.ini"
    std::string_view meaning = ""; ///< one line
    std::string_view example = ""; ///< shown where words are missing
    OutKind out = OutKind::folder;
    std::string_view extension = ""; ///< of OutKind::file
    std::string_view suffix = "";    ///< of the default name, where another verb has it too
    std::size_t least = 1, most = 1; ///< number of words
    std::string_view sections = "";  ///< of the study file that it reads, between blanks
    int (*run)(const Command&) = nullptr; ///< returns the exit code
};

/// nullptr if there is no verb of this name.
[[nodiscard]] const Verb* find_verb(std::span<const Verb> verbs, std::string_view name);

/// The same, or an error that says which verb was probably meant.
/// @throws ConfigError
[[nodiscard]] const Verb& known_verb(std::span<const Verb> verbs, std::string_view name);

/// Whether `word` is one of the words of `list`, which are divided by blanks.
[[nodiscard]] bool is_listed(std::string_view word, std::string_view list);

} // namespace app
