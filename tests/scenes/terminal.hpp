#pragma once

#include <iostream>
#include <sstream>
#include <string>

namespace scenes {

/// Takes what is written to std::cout as long as it lives.
class Terminal {
  public:
    Terminal() : screen_(std::cout.rdbuf(text_.rdbuf())) {}
    ~Terminal() { std::cout.rdbuf(screen_); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    [[nodiscard]] std::string text() const { return text_.str(); }

  private:
    std::ostringstream text_;
    std::streambuf* screen_;
};

} // namespace scenes
