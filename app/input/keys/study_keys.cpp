#include "app/input/keys/study_keys.hpp"

#include "app/input/keys/study_key_table.hpp"

#include <vector>

namespace app {

std::span<const Key> study_keys()
{
    static const std::vector<Key> all = [] {
        std::vector<Key> keys;
        for (const auto part :
             {wall_keys(), joint_keys(), unit_keys(), support_keys(), shaking_keys(),
              solver_keys(), random_keys(), calibration_keys()})
            keys.insert(keys.end(), part.begin(), part.end());
        return keys;
    }();
    return all;
}

std::string_view section_of(std::string_view key) { return key.substr(0, key.find('.')); }

std::string_view name_in_section(std::string_view key) { return key.substr(key.find('.') + 1); }

const Key* find_key(std::string_view name)
{
    for (const Key& key : study_keys())
        if (key.name == name) return &key;
    return nullptr;
}

namespace {

bool holds(const Condition& condition, const Study& study)
{
    return condition.holds == nullptr || condition.holds(study);
}

} // namespace

bool says_how_a_file_is_read(const Key& key)
{
    return key.name == "wall.geometry" || key.used.holds == kOfFile.holds;
}

bool is_used(const Key& key, const Study& study) { return holds(key.used, study); }

std::string_view why_no_effect(const Key& key, const Study& study)
{
    if (!holds(key.used, study)) return key.used.otherwise;
    return holds(key.effect, study) ? "" : key.effect.otherwise;
}

} // namespace app
