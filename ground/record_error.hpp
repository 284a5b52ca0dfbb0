#pragma once

#include <stdexcept>
#include <string>

namespace ground {

/// A record that cannot be used. what() is one clickable line: `file:line: what is wrong; what
/// to write`.
class RecordError : public std::runtime_error {
  public:
    /// @param line from 1; 0 if there is none, then left out
    RecordError(const std::string& file, int line, const std::string& why)
        : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : std::string()) +
                             ": " + why),
          file_(file), why_(why), line_(line)
    {
    }
    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] const std::string& why() const { return why_; }
    [[nodiscard]] int line() const { return line_; }

  private:
    std::string file_, why_;
    int line_;
};

} // namespace ground
