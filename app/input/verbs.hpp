#pragma once
/// The verbs of the command line: what each takes.

#include <span>
#include <string_view>

namespace app {

enum class Verb {
    help,
    version,
    push,
    study,
    sample,
    fragility,
    report,
    merge,
    reliability,
    curves
};

/// What --out names.
enum class OutKind {
    folder,    ///< default runs/<name of the study file>
    file,      ///< default runs/<name of the study file> and the extension
    first_word ///< no --out: the first word after the verb
};

struct VerbRule {
    Verb verb;
    std::string_view name;
    std::string_view words;   ///< "STUDY.ini", for usage lines
    std::string_view meaning; ///< one line
    OutKind out;
    std::string_view extension;                ///< of OutKind::file
    std::size_t least, most;                   ///< number of words
    std::span<const std::string_view> options; ///< those it takes
    std::string_view example;                  ///< what to write where words are missing
};

/// Without help and version.
[[nodiscard]] std::span<const VerbRule> verb_rules();

/// nullptr if the word is none of them.
[[nodiscard]] const VerbRule* find_verb(std::string_view name);
[[nodiscard]] const VerbRule& rule_of(Verb verb);

[[nodiscard]] bool takes(const VerbRule& rule, std::string_view option);

} // namespace app
