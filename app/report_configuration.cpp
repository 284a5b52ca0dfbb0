#include "app/report_configuration.hpp"

#include "app/study_keys.hpp"
#include "app/words.hpp"

namespace app {
namespace {

bool follows_from_others(const std::string& key)
{
    const Key* known = find_key(key);
    return known != nullptr && known->derived.apply != nullptr;
}

/// How results are read and what is asked of them: may be of another version.
bool no_part_of_a_wall(std::string_view section)
{
    return section == "fragility" || section == "reliability";
}

} // namespace

std::string without_derived(std::string_view configuration)
{
    std::string kept, section;
    while (!configuration.empty()) {
        const std::size_t end = configuration.find('\n');
        const std::string_view line = configuration.substr(0, end);
        configuration.remove_prefix(end == line.npos ? configuration.size() : end + 1);
        const std::string_view words = trimmed(line);
        if (words.starts_with('[')) section = words.substr(1, words.find(']') - 1);
        const std::string key =
            section + "." + std::string(trimmed(line.substr(0, line.find('='))));
        const bool dropped = no_part_of_a_wall(section) ||
                             (words.ends_with("# default") && follows_from_others(key));
        // an empty line in its place: lines keep their numbers
        kept += dropped ? "\n" : std::string(line) + "\n";
    }
    return kept;
}

Study read_configuration(const std::string& name, std::string_view configuration)
{
    return read_study(parse_study_text(name, without_derived(configuration)));
}

} // namespace app
