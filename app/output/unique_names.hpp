#pragma once
/// Names of files and IDs, no two alike.

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

namespace app {

class UniqueNames {
  public:
    /// `wanted`, or with "_2", "_3", ... after it where that name is taken, also in other letters' case:
    /// some disks do not tell them apart.
    std::string add(const std::string& wanted)
    {
        std::string name = wanted;
        for (int n = 2; !taken_.insert(lower(name)).second; ++n)
            name = wanted + "_" + std::to_string(n);
        return name;
    }

  private:
    static std::string lower(std::string text)
    {
        std::ranges::transform(text, text.begin(), [](unsigned char c) {
            return static_cast<char>(std::tolower(c));
        });
        return text;
    }

    std::set<std::string> taken_;
};

} // namespace app
