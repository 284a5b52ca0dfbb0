#pragma once
/// Small drawings as text, and what is read from them.

#include "app/drawing/outlines/drawing.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace scenes {

/// Coordinates of one outline, x and z by turns.
using Outline = std::vector<double>;

/// A rectangle, counter-clockwise.
[[nodiscard]] Outline rectangle(double left, double bottom, double right, double top);

/// `text` as the file `name`, read.
[[nodiscard]] app::Drawing drawing_of(const std::string& name, std::string_view text,
                                      const app::DrawingOptions& options = {});

/// The message with which it is refused, without the folder; "read" if it is read.
[[nodiscard]] std::string refusal(const std::string& name, std::string_view text,
                                  const app::DrawingOptions& options = {});

/// {"blocks": ...}, one block per line: the first on line 2.
[[nodiscard]] std::string json_text(const std::vector<Outline>& outlines);

/// A file of R12 with only these entities.
[[nodiscard]] std::string dxf_text(const std::string& entities);

/// @param closed group 70
[[nodiscard]] std::string lwpolyline(const Outline& outline, bool closed = true,
                                     const std::string& layer = "0");

[[nodiscard]] std::string dxf_line(double x, double y, double to_x, double to_y,
                                   const std::string& layer = "0");

/// A wall of courses of rectangles of 200 x 100, every second of them shifted by half a unit.
[[nodiscard]] std::vector<Outline> running_bond(int units, int courses);

/// A picture of grey or coloured pixels: each 0xRRGGBB.
struct Pixels {
    int columns = 0, rows = 0;
    std::vector<int> colour; ///< row by row, from the top

    [[nodiscard]] int& at(int column, int row)
    {
        return colour[static_cast<std::size_t>(row * columns + column)];
    }
    void fill(int left, int top, int right, int bottom, int value);
};
[[nodiscard]] Pixels pixels(int columns, int rows, int colour = 0);

/// The bytes of a PNG file.
[[nodiscard]] std::string png_bytes(const Pixels& picture);

[[nodiscard]] double area(const app::DrawnBlock& block);
[[nodiscard]] double area(const app::Drawing& drawing);

/// Sides that two blocks share bit by bit, in opposite directions.
[[nodiscard]] int common_sides(const app::Drawing& drawing);

/// True if a note has this text.
[[nodiscard]] bool notes(const app::Drawing& drawing, std::string_view text);

} // namespace scenes
