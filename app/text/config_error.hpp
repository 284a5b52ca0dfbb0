#pragma once
/// Bad input: the only exception that leaves the reading of a study or of the command line.

#include <stdexcept>
#include <string>
#include <string_view>

namespace app {

/// what() is one clickable line: `file:line: key: what is wrong; what to write`.
class ConfigError : public std::runtime_error {
  public:
    /// @param file path of the study file, or where else the input came from (`--set`,
    /// `drystone`)
    /// @param line from 1; 0 if there is none, then left out
    /// @param key `section.key` or an option; left out if empty
    ConfigError(std::string_view file, int line, std::string_view key, std::string_view why)
        : std::runtime_error(
              std::string(file) + (line > 0 ? ":" + std::to_string(line) : std::string()) +
              ": " + (key.empty() ? std::string() : std::string(key) + ": ") + std::string(why))
    {
    }
};

} // namespace app
