#pragma once
/// Some of the verbs, written as their names between blanks. The compiler refuses a name that
/// is no verb.

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace app {

inline constexpr std::array<std::string_view, 22> kVerbNames = {
    "push",    "scene",       "new",       "stones",    "study",  "status",
    "sample",  "reliability", "fragility", "calibrate", "report", "sheet",
    "choices", "compare",     "surrogate", "curves",    "record", "shake",
    "serve",   "merge",       "help",      "version"};

class VerbSet {
  public:
    constexpr VerbSet() = default;
    /// "push study": where a verb is not of kVerbNames, the program does not compile.
    consteval VerbSet(const char* names) // NOLINT: a list is written as a text
    {
        std::string_view left = names;
        while (!left.empty()) {
            const std::size_t blank = left.find(' ');
            bits_ |= bit_of(left.substr(0, blank));
            left.remove_prefix(blank == std::string_view::npos ? left.size() : blank + 1);
        }
    }

    [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }

    /// @param verb one of kVerbNames
    [[nodiscard]] constexpr bool has(std::string_view verb) const
    {
        return (bits_ & bit_of(verb)) != 0;
    }

  private:
    static constexpr std::uint32_t bit_of(std::string_view verb)
    {
        for (std::size_t i = 0; i < kVerbNames.size(); ++i)
            if (kVerbNames[i] == verb) return std::uint32_t{1} << i;
        throw std::invalid_argument("no verb");
    }

    std::uint32_t bits_ = 0;
};

} // namespace app
