#include "app/input/study_keys.hpp"

#include "app/input/study_key_table.hpp"

#include <vector>

namespace app {

std::span<const Key> study_keys()
{
    static const std::vector<Key> all = [] {
        std::vector<Key> keys;
        for (const auto part : {wall_keys(), solver_keys(), random_keys()})
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

bool is_used(const Key& key, const Study& study)
{
    switch (key.used) {
    case Used::always:
        return true;
    case Used::with_cracks:
        return study.wall.cracks_in_units;
    case Used::with_base_joint:
        return study.wall.base == dem::Base::joint;
    case Used::with_beam_joint:
        return study.beam.interface == dem::BeamInterface::joint;
    case Used::with_fields:
        return study.uq.spatial == Spatial::correlated;
    }
    return true;
}

} // namespace app
