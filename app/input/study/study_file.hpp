#pragma once
/// A study file as text: sections, keys and values, each with its line. What they mean:
/// app/input/study.

#include "app/text/config_error.hpp"

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// One `key = value` of a study.
struct Entry {
    std::string key;     ///< section.key
    std::string value;   ///< as written, without comment; not empty
    int line = 0;        ///< from 1; 0: given with --set
    bool preset = false; ///< of the material that `line` names, and not written in the file
};

struct SectionHeader {
    std::string name;
    int line = 0; ///< where it is first opened, from 1
};

struct StudyFile {
    std::string path;
    std::vector<Entry> entries; ///< in the order of the file, then of --set; keys differ
    std::vector<SectionHeader> sections; ///< names differ
    int last_line = 1;
};

/// Read an INI file: `[section]`, `key = value`, `# comment`. UTF-8, with or without byte order
/// mark, lines ending in LF or CRLF.
/// @throws ConfigError if the path cannot be read as such a text, or a key is empty or doubled
[[nodiscard]] StudyFile read_study_file(const std::string& path);

/// The same from a text; path only names it.
[[nodiscard]] StudyFile parse_study_text(const std::string& path, std::string_view text);

/// The file with the values of `section.key=value` put in place of its own. An empty value
/// takes the key out of the file.
/// @throws ConfigError if an assignment is malformed or doubled, or takes out a key that is not
/// there
[[nodiscard]] StudyFile with_overrides(StudyFile file,
                                       std::span<const std::string> assignments);

/// nullptr if the key is not given.
[[nodiscard]] const Entry* find_entry(const StudyFile& file, std::string_view key);
[[nodiscard]] inline bool is_given(const StudyFile& file, std::string_view key)
{
    return find_entry(file, key) != nullptr;
}

/// The path of a file that the value of a key names: one written in a study counts from the
/// folder of the study, one given with --set from the current folder.
[[nodiscard]] std::filesystem::path path_from(const StudyFile& file, std::string_view key,
                                              const std::filesystem::path& written);

/// nullptr if the section is not opened.
[[nodiscard]] const SectionHeader* find_section(const StudyFile& file, std::string_view name);

/// An error about a key: where it is given, else where its section opens, else at the last
/// line.
[[nodiscard]] ConfigError error_at(const StudyFile& file, std::string_view key,
                                   std::string_view why);

/// Returns what read() returns. If that throws std::invalid_argument, such as BadValue, that
/// becomes an error about the key.
template <class Read>
decltype(auto) read_at(const StudyFile& file, std::string_view key, Read read)
{
    try {
        return read();
    } catch (const std::invalid_argument& bad) {
        throw error_at(file, key, bad.what());
    }
}

} // namespace app
