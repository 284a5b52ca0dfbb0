#include "app/store/record_keys.hpp"

#include <algorithm>
#include <sstream>

namespace app {

std::string without_record_keys(const std::string& configuration)
{
    std::istringstream in(configuration);
    std::string text, section;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('[')) section = line.substr(1, line.find(']') - 1);
        const std::string key =
            section + '.' + line.substr(0, std::min(line.find_first_of(" ="), line.size()));
        if (std::ranges::find(kRecordKeys, key) == kRecordKeys.end()) text += line + "\n";
    }
    return text;
}

} // namespace app
