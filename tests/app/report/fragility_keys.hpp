#pragma once
/// Every key of [fragility] with a value that is not its default, from the table of keys.

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/text/number_text.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace scenes {

/// "fragility.law=gamma" and so on; codes and user_states bring their sets.
inline std::vector<std::string> changed(const app::Key& key)
{
    const std::string name(key.name);
    const app::Study standard;
    const double value = key.kind == app::Kind::text ? 0.0 : key.field.get(standard).front();
    switch (key.kind) {
    case app::Kind::word:
        for (const app::Named& n : key.names)
            if (n.value != value) return {name + "=" + std::string(n.word)};
        break;
    case app::Kind::number: // towards the upper end of its range
        return {name + "=" + app::number(0.5 * (value + key.range.high), 6)};
    case app::Kind::count:
        return {name + "=" + app::number(value > 100 ? 0.5 * value : value + 2, 6)};
    default:
        if (name.starts_with("fragility.model_factor"))
            return {name + "=lognormal(median 0.8, sigma_log 0.4)"};
        if (name == "fragility.limit_states") return {name + "=ec8, paper"};
        if (name == "fragility.codes")
            return {name + R"(={"codes": [{"name": "mine", "title": "Mine", "states": )"
                           R"([{"name": "CP", "rule": "drop 0.9", "source": "me"}]}]})",
                    "fragility.limit_states=paper, mine"};
        if (name == "fragility.user_states")
            return {name + "=mine: 0.5 ultimate; far: 0.6 %",
                    "fragility.limit_states=paper, user"};
    }
    throw std::logic_error("no other value is known for " + name);
}

inline bool is_of_shaken_walls(const app::Key& key)
{
    app::Study pushed, shaken;
    shaken.shaking.records = "a.csv";
    return is_used(key, shaken) && !is_used(key, pushed);
}

/// One list of overrides for each key that a push reads.
inline std::vector<std::vector<std::string>> changed_fragility_keys()
{
    std::vector<std::vector<std::string>> all;
    for (const app::Key& key : app::study_keys())
        if (app::section_of(key.name) == "fragility" && !is_of_shaken_walls(key))
            all.push_back(changed(key));
    return all;
}

} // namespace scenes
