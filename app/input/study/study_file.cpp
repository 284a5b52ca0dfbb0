#include "app/input/study/study_file.hpp"

#include "app/text/text_file.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <sstream>

namespace app {
namespace {

bool is_name(std::string_view text)
{
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz_0123456789"
                                          "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    return !text.empty() && text.find_first_not_of(kLetters) == std::string_view::npos;
}

std::string_view without_comment(std::string_view line)
{
    return trimmed(line.substr(0, line.find('#')));
}

/// Reads one line after the other into the entries and sections of a file.
class LineReader {
  public:
    explicit LineReader(StudyFile& file) : file_(file) {}

    void next(std::string_view raw)
    {
        ++line_;
        const std::string_view line = without_comment(raw);
        if (line.empty()) return;
        if (line.front() == '[') return open_section(line);
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) {
            refuse("", in_quotes(line) + " is neither [section], key = value nor # comment");
        }
        add_key(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
    }

  private:
    [[noreturn]] void refuse(std::string_view key, const std::string& why) const
    {
        throw ConfigError(file_.path, line_, key, why);
    }

    void open_section(std::string_view line)
    {
        const std::string_view name = line.substr(1, line.size() - 2);
        if (line.size() < 3 || line.back() != ']' || !is_name(name)) {
            refuse("", "malformed section " + in_quotes(line) +
                           "; write its name alone in brackets, such as [wall]");
        }
        section_ = name;
        const bool known = std::ranges::any_of(
            file_.sections, [&](const auto& s) { return s.name == section_; });
        if (!known) file_.sections.push_back({section_, line_});
    }

    void add_key(std::string_view name, std::string_view value)
    {
        if (!is_name(name)) {
            refuse("", "malformed key " + in_quotes(name) +
                           "; write letters, digits and _ before the =");
        }
        if (section_.empty()) {
            refuse(name, "outside a section; open one above it, such as [wall]");
        }
        const std::string key = section_ + "." + std::string(name);
        if (value.empty()) refuse(key, "empty value; write one after the =");
        if (const Entry* first = find_entry(file_, key)) {
            refuse(key, "given twice, first on line " + std::to_string(first->line) +
                            "; keep one of them");
        }
        file_.entries.push_back({key, std::string(value), line_});
    }

    StudyFile& file_;
    std::string section_;
    int line_ = 0;
};

} // namespace

StudyFile parse_study_text(const std::string& path, std::string_view text)
{
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // byte order mark
    if (!is_text(text)) {
        throw ConfigError(path, 0, "",
                          "is not UTF-8 text; save the study as plain text in UTF-8");
    }
    StudyFile file{path, {}, {}, 0};
    LineReader reader(file);
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line); ++file.last_line) reader.next(line);
    if (file.entries.empty()) {
        throw ConfigError(path, std::max(1, file.last_line), "",
                          "no key in the file; configs/wall.ini shows a complete study");
    }
    return file;
}

StudyFile read_study_file(const std::string& path)
{
    return parse_study_text(path, read_small_file(path));
}

StudyFile with_overrides(StudyFile file, std::span<const std::string> assignments)
{
    for (const std::string& text : assignments) {
        const std::size_t equals = std::min(text.find('='), text.size());
        const std::string key(trimmed(std::string_view(text).substr(0, equals)));
        const std::size_t dot = std::min(key.find('.'), key.size());
        const std::string_view parts = key;
        if (equals == text.size() || dot == key.size() || !is_name(parts.substr(0, dot)) ||
            !is_name(parts.substr(dot + 1))) {
            throw ConfigError("--set", 0, "",
                              in_quotes(text) +
                                  " is not an assignment; write section.key=value, "
                                  "such as joint.friction_angle=\"30 deg\"");
        }
        const std::string value(trimmed(std::string_view(text).substr(equals + 1)));
        if (value.find_first_of("#\n\r") != std::string::npos) {
            throw ConfigError("--set", 0, key,
                              in_quotes(value) + " has a # or a line break, which a study file "
                                                 "cannot keep in a value; leave it out");
        }
        const auto given =
            std::ranges::find_if(file.entries, [&](const Entry& e) { return e.key == key; });
        if (given != file.entries.end() && given->line == 0) {
            throw ConfigError("--set", 0, key, "given twice; keep one of them");
        } else if (value.empty() && given == file.entries.end()) {
            throw ConfigError(
                "--set", 0, key,
                "empty value of a key that is not in the file; write one after the =");
        } else if (value.empty()) {
            file.entries.erase(given);
        } else if (given == file.entries.end()) {
            file.entries.push_back({key, value, 0});
        } else {
            *given = {key, value, 0};
        }
    }
    return file;
}

const Entry* find_entry(const StudyFile& file, std::string_view key)
{
    const auto found =
        std::ranges::find_if(file.entries, [&](const Entry& e) { return e.key == key; });
    return found == file.entries.end() ? nullptr : &*found;
}

std::filesystem::path path_from(const StudyFile& file, std::string_view key,
                                const std::filesystem::path& written)
{
    const Entry* entry = find_entry(file, key);
    if (entry != nullptr && entry->line == 0) return written;
    return std::filesystem::path(file.path).parent_path() / written;
}

const SectionHeader* find_section(const StudyFile& file, std::string_view name)
{
    const auto found = std::ranges::find_if(
        file.sections, [&](const SectionHeader& s) { return s.name == name; });
    return found == file.sections.end() ? nullptr : &*found;
}

ConfigError error_at(const StudyFile& file, std::string_view key, std::string_view why)
{
    if (const Entry* entry = find_entry(file, key)) {
        return {entry->line > 0 ? std::string_view(file.path) : "--set", entry->line, key, why};
    }
    const SectionHeader* section = find_section(file, key.substr(0, key.find('.')));
    return {file.path, section == nullptr ? file.last_line : section->line, key, why};
}

} // namespace app
