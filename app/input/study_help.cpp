#include "app/input/study_help.hpp"

#include "app/input/key_values.hpp"
#include "app/input/study_keys.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace app {
namespace {

std::string default_text(const Key& key)
{
    if (!key.example.empty()) return "required";
    if (!key.derived.rule.empty()) return std::string(key.derived.rule);
    return value_text(key, Study{});
}

/// At least one blank before the next column.
void fill_to(std::string& line, std::size_t column)
{
    line.resize(std::max(line.size() + 1, column), ' ');
}

} // namespace

std::string study_help()
{
    std::string text;
    std::string_view section;
    for (const Key& key : study_keys()) {
        if (section_of(key.name) != section) {
            section = section_of(key.name);
            text += "\n[" + std::string(section) + "]\n";
        }
        std::string line = "  " + std::string(name_in_section(key.name));
        fill_to(line, 28);
        line += default_text(key);
        fill_to(line, 52);
        text += line + allowed_values(key) + "\n      " + std::string(key.meaning) + "\n";
    }
    return text;
}

} // namespace app
