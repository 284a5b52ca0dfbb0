#pragma once
/// The table of all keys of a study. It drives reading, range checks, defaults, help and the
/// effective configuration.

#include "app/input/keys/study_field.hpp"
#include "app/input/keys/verb_set.hpp"
#include "app/input/study/key_range.hpp"

#include <span>
#include <string>
#include <string_view>

namespace app {

enum class Kind {
    number,
    list,  ///< of numbers
    count, ///< a whole number
    word,  ///< one of Key::names and nothing else
    text   ///< free text, read elsewhere
};

/// When a key plays a part.
struct Condition {
    bool (*holds)(const Study&) = nullptr; ///< nullptr: always
    std::string_view otherwise = "";       ///< why it plays none: "wall.unit_cracks is no"
    bool refused = false; ///< a value given although the condition does not hold is an error
};

/// A function of parts of a study, for tables: asks<&Study::load>([](auto& load) { ... }).
template <auto... Parts, class Function> constexpr auto asks(Function)
{
    return +[](const Study& study) { return Function{}((study.*Parts)...); };
}

/// A word that stands for a value.
struct Named {
    std::string_view word;
    double value = 0.0;
};

/// A default that follows from other values.
struct Derived {
    std::string_view rule;           ///< in words
    void (*apply)(Study&) = nullptr; ///< applied once, when the study is read
    /// For parameters: applied anew to every draw. Without both, the rule says what else to
    /// give.
    void (*follow)(Parameters&, double course_height) = nullptr;
};

struct Key {
    std::string_view name; ///< section.key
    Kind kind = Kind::number;
    std::string_view unit = ""; ///< preferred; others of the same quantity are read as well
    Range range = {};           ///< of numbers; named values are free of it
    std::span<const Named> names = {}; ///< words in place of numbers
    Condition used = {};   ///< otherwise the key is not required, not derived and not shown
    Condition effect = {}; ///< otherwise its value changes nothing, and the user is told
    VerbSet verbs = {};    ///< that it concerns; empty: all
    std::string_view example = ""; ///< of a key that must be given; empty: it has a default
    Derived derived = {};          ///< empty: the default is the one of the field
    Varies varies = Varies::never; ///< otherwise a distribution is a value too
    std::string_view fixed_because = ""; ///< why it cannot be drawn, where a user may expect it
    std::string_view meaning = "";       ///< one line, with its source
    Field field = {};
};

/// Section by section.
[[nodiscard]] std::span<const Key> study_keys();

/// The keys of a study of another program; its section [variables] has names of its own.
[[nodiscard]] std::span<const Key> program_keys();

/// "wall" of "wall.length"
[[nodiscard]] std::string_view section_of(std::string_view key);

/// "length" of "wall.length"
[[nodiscard]] std::string_view name_in_section(std::string_view key);

/// nullptr if there is none.
[[nodiscard]] const Key* find_key(std::string_view name);

/// Whether a key tells of a file whose content the study keeps.
[[nodiscard]] bool says_how_a_file_is_read(const Key& key);

[[nodiscard]] bool is_used(const Key& key, const Study& study);

/// Why the value of a key changes nothing in this study; empty if it does.
[[nodiscard]] std::string_view why_no_effect(const Key& key, const Study& study);

} // namespace app
