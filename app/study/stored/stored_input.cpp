#include "app/study/stored/stored_input.hpp"

#include "app/input/keys/study_keys.hpp"
#include "app/input/study/units.hpp"

namespace app {
namespace {

/// The unit of the key. A key that this version does not have is shown as it is stored.
void set_shown_unit(StoredInput& input, const std::string& stored)
{
    const Key* key = find_key(input.key);
    const bool has_unit = key != nullptr && !key->unit.empty() && si_unit(key->unit) == stored;
    input.unit = has_unit ? std::string(key->unit) : stored;
    input.scale = has_unit ? from_si(1.0, key->unit) : 1.0;
}

/// "joint.friction_angle" of "joint.friction_angle.17"
std::string without_number(const std::string& name)
{
    const std::size_t dot = name.rfind('.');
    const bool numbered = dot != std::string::npos && dot + 1 < name.size() &&
                          name.find_first_not_of("0123456789", dot + 1) == std::string::npos;
    return numbered ? name.substr(0, dot) : name;
}

} // namespace

std::vector<StoredInput> stored_inputs(const std::vector<Column>& columns)
{
    std::vector<StoredInput> inputs;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string key = without_number(columns[i].name);
        if (!inputs.empty() && inputs.back().key == key) {
            ++inputs.back().count;
            continue;
        }
        inputs.push_back({key, "", 1.0, i, 1, {}});
        set_shown_unit(inputs.back(), columns[i].unit);
    }
    return inputs;
}

double shown_value(const StoredInput& input, const WallRow& wall)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < input.count; ++i) sum += wall.inputs[input.first + i];
    return input.scale * sum / static_cast<double>(input.count);
}

} // namespace app
