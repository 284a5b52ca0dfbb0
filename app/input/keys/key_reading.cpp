#include "app/input/keys/key_reading.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/study/units.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace app {
namespace {

using Keys = std::span<const Key>;

std::vector<std::string_view> section_names(Keys keys)
{
    std::vector<std::string_view> names;
    for (const Key& key : keys) {
        const std::string_view section = section_of(key.name);
        if (std::ranges::find(names, section) == names.end()) names.push_back(section);
    }
    return names;
}

void refuse_unknown_section(const StudyFile& file, Keys keys, int line,
                            std::string_view section)
{
    const std::string_view path = line > 0 ? std::string_view(file.path) : "--set";
    const std::string shown = "[" + std::string(section) + "]";
    const auto names = section_names(keys);
    if (std::ranges::find(names, section) == names.end()) {
        throw ConfigError(path, line, shown, "unknown section; " + suggestion(section, names));
    }
}

void refuse_unknown_key(const StudyFile& file, Keys keys, const Entry& entry)
{
    std::vector<std::string_view> all, in_section;
    for (const Key& key : keys) {
        if (key.name == entry.key) return;
        all.push_back(key.name);
        if (section_of(key.name) == section_of(entry.key)) {
            in_section.push_back(name_in_section(key.name));
        }
    }
    const std::string_view nearest = nearest_word(entry.key, all);
    throw error_at(file, entry.key,
                   "unknown key; " + (nearest.empty()
                                          ? "use " + listed(in_section)
                                          : "did you mean " + in_quotes(nearest) + "?"));
}

/// A field whose value is a distribution holds its mean.
void read_value(const Key& key, const std::string& text, Study& study)
{
    if (auto random = parse_random(key, text)) {
        key.field.set(study, {random->mean});
        study.random.push_back(std::move(*random));
    } else {
        key.field.set(study, parse_value(key, text));
    }
}

/// A value to write for a key that is missing. Nothing carries a vertical stress where there is
/// no beam, so that another example would be refused in turn.
std::string_view example_of(const Key& key, const dem::Beam& beam)
{
    return key.name == "load.vertical_stress" && !beam.present ? "0 MPa" : key.example;
}

} // namespace

void refuse_unknown(const StudyFile& file, std::span<const Key> keys,
                    std::string_view free_section)
{
    for (const SectionHeader& s : file.sections)
        if (s.name != free_section) refuse_unknown_section(file, keys, s.line, s.name);
    for (const Entry& e : file.entries) {
        if (section_of(e.key) == free_section) continue;
        refuse_unknown_section(file, keys, e.line, section_of(e.key));
        refuse_unknown_key(file, keys, e);
    }
}

void read_key(const Key& key, Study& study)
{
    if (const Entry* entry = find_entry(study.source, key.name)) {
        read_at(study.source, key.name, [&] { read_value(key, entry->value, study); });
    } else if (!key.example.empty() && is_used(key, study)) {
        throw error_at(study.source, key.name,
                       "missing; write e.g. \"" + std::string(name_in_section(key.name)) +
                           " = " + std::string(example_of(key, study.beam)) + "\" under [" +
                           std::string(section_of(key.name)) + "]");
    }
}

} // namespace app
