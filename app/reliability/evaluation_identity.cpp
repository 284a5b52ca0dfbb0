#include "app/reliability/evaluation_identity.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/study/units.hpp"
#include "app/study/stored/study_identity.hpp"
#include "app/study/stored/wanted_walls.hpp"

#include <span>
#include <string_view>

namespace app {
namespace {

/// Values of a section, one line each.
std::string section_text(std::span<const Key> keys, std::string_view section,
                         const Study& study)
{
    std::string text;
    for (const Key& key : keys)
        if (section_of(key.name) == section)
            text += std::string(key.name) + " = " + value_text(key, study) + '\n';
    return text;
}

} // namespace

std::string wall_evaluations(const Study& study, const std::string& level)
{
    const double stress = study.load.vertical_stress[level_of(study.load, level)];
    return identity_text(study) + section_text(study_keys(), "fragility", study) +
           "level = " + format_quantities({&stress, 1}, "MPa") + '\n';
}

std::string program_evaluations(const Study& study)
{
    std::string text = section_text(program_keys(), "model", study);
    for (const RandomInput& r : study.random) text += "variable = " + r.key + '\n';
    return text;
}

} // namespace app
