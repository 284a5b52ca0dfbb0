#pragma once
/// The pairs of lines that a DXF file is made of: a group code and its value.

#include "app/drawing/outlines/raw_drawing.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace app {

struct DxfGroup {
    int code = 0;           ///< what the value means, in [-5, 1071]
    std::string_view value; ///< without the blanks and the carriage return around it
    int line = 0;           ///< of the value, from 1
};

/// Reads one pair after the other. A reader of our own: Debian's libdxflib keeps no line
/// numbers, so that a message could not say where the mistake is, and passes over pairs that it
/// cannot read.
class DxfGroups {
  public:
    /// @param text must outlive this
    DxfGroups(const DrawingFrame& frame, std::string_view text) : frame_(frame), text_(text) {}

    /// Nothing at the end of the file.
    /// @throws ConfigError if a code is no number, or has no value
    [[nodiscard]] std::optional<DxfGroup> next();

    /// The next call of next() gives the last group once more.
    void step_back();

    [[nodiscard]] int line() const { return line_; }

    /// A place between two groups.
    struct Place {
        std::size_t at = 0; ///< byte of the text
        int line = 0;       ///< before it
    };
    [[nodiscard]] Place place() const { return {at_, line_}; }
    /// The next call of next() gives the group behind that place.
    void go_to(Place place);

  private:
    [[nodiscard]] std::string_view take_line();

    const DrawingFrame& frame_;
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t last_ = 0;
    int line_ = 0;
};

/// The number of a group.
/// @throws ConfigError if it is none, or not finite
[[nodiscard]] double dxf_number(const DrawingFrame& frame, const DxfGroup& group);

/// The whole number of a group.
/// @throws ConfigError if it is none
[[nodiscard]] int dxf_integer(const DrawingFrame& frame, const DxfGroup& group);

} // namespace app
