#pragma once
/// Readings of a whole SVG file before its shapes are read: the elements, the style sheets, and
/// the unit of length.

#include "app/drawing/svg_element.hpp"
#include "app/drawing/svg_sheet.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace app {

/// An element of the file.
struct SvgNode {
    std::string name; ///< without "svg:"
    std::vector<std::string> attributes;
    int line = 0;
    std::size_t end = 0; ///< one behind the last element within it
};

/// The elements of a file, each before those within it.
struct SvgNodes {
    std::vector<SvgNode> all;
    std::map<std::string, std::size_t> by_id; ///< the first of each
    int error_line = 0;                       ///< where it ceases to be XML; 0: nowhere
    std::string error;
};

/// Elements that stand before an error are among them.
[[nodiscard]] SvgNodes svg_nodes(std::string_view bytes);

/// The one element of a switch that every program draws in every language, the first without a
/// condition: its place and the one after it; the same twice if there is none.
[[nodiscard]] std::pair<std::size_t, std::size_t> drawn_of_switch(const SvgNodes& nodes,
                                                                  std::size_t at);

/// All style sheets of the file, also those that stand behind the shapes.
/// @throws ConfigError if a rule that may hide or move shapes cannot be read
[[nodiscard]] SvgStyleSheet svg_sheets(const DrawingFrame& frame, std::string_view bytes);

/// States the unit of the drawing that follows from width="1000mm" height="800mm" and
/// viewBox="0 0 1000 800". px are units of the drawing, not lengths.
/// @throws ConfigError if the page stretches the drawing in one direction
void state_page_unit(RawDrawing& drawing, const SvgElement& root);

} // namespace app
