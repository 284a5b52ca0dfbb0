#include "app/input/verb.hpp"

#include <sstream>
#include <string>

namespace app {

const Verb* find_verb(std::span<const Verb> verbs, std::string_view name)
{
    for (const Verb& v : verbs)
        if (v.name == name) return &v;
    return nullptr;
}

bool is_listed(std::string_view word, std::string_view list)
{
    std::istringstream words{std::string(list)};
    for (std::string w; words >> w;)
        if (w == word) return true;
    return false;
}

} // namespace app
