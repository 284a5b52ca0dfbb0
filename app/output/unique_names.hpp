#pragma once
/// Names of files and IDs, no two alike.

#include "app/text/words.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace app {

/// Letters, digits, dots and hyphens of a name, at most 60; others become '_'.
/// @param otherwise where nothing is left
inline std::string plain_name(const std::string& name, const std::string& otherwise)
{
    constexpr std::size_t kLongest = 60;
    std::string safe;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '.' || c == '-';
        if (plain || (!safe.empty() && safe.back() != '_')) safe += plain ? c : '_';
    }
    safe.resize(std::min(safe.size(), kLongest));
    while (safe.ends_with('_')) safe.pop_back();
    return safe.empty() ? otherwise : safe;
}

class UniqueNames {
  public:
    /// `wanted`, or with "_2", "_3", ... after it where that name is taken, also in other
    /// letters' case: some disks do not tell them apart.
    std::string add(const std::string& wanted)
    {
        std::string name = wanted;
        for (int n = 2; !taken_.insert(lower_case(name)).second; ++n)
            name = wanted + "_" + std::to_string(n);
        return name;
    }

  private:
    std::set<std::string> taken_;
};

} // namespace app
