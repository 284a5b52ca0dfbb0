#include "app/input/verb.hpp"

#include "app/input/study_name.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace app {

const Verb* find_verb(std::span<const Verb> verbs, std::string_view name)
{
    for (const Verb& v : verbs)
        if (v.name == name) return &v;
    return nullptr;
}

const Verb& known_verb(std::span<const Verb> verbs, std::string_view name)
{
    if (const Verb* verb = find_verb(verbs, name)) return *verb;
    const auto use = [&](const char* verb) {
        throw ConfigError("drystone", 0, name,
                          "missing verb; write \"drystone " + std::string(verb) + " " +
                              std::string(name) + "\"");
    };
    if (name.ends_with(".ini")) use("push");
    if (is_study_name(name)) use("fragility");
    std::vector<std::string_view> names;
    for (const Verb& v : verbs) names.push_back(v.name);
    throw ConfigError("drystone", 0, name, "unknown verb; " + suggestion(name, names));
}

bool is_listed(std::string_view word, std::string_view list)
{
    std::istringstream words{std::string(list)};
    for (std::string w; words >> w;)
        if (w == word) return true;
    return false;
}

} // namespace app
