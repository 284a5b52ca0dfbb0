#pragma once
/// Readings of a whole SVG file before its shapes are read: the parser, the style sheets, and
/// the unit of length.

#include "app/drawing/svg_element.hpp"
#include "app/drawing/svg_sheet.hpp"

#include <expat.h>

#include <memory>
#include <string_view>
#include <type_traits>

namespace app {

using SvgParser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)>;

/// @throws std::bad_alloc
[[nodiscard]] SvgParser svg_parser();

/// All style sheets of the file, also those that stand behind the shapes.
/// @throws ConfigError if a rule that may hide or move shapes cannot be read
[[nodiscard]] SvgStyleSheet svg_sheets(const DrawingFrame& frame, std::string_view bytes);

/// States the unit of the drawing that follows from width="1000mm" height="800mm" and
/// viewBox="0 0 1000 800". px are units of the drawing, not lengths.
/// @throws ConfigError if the page stretches the drawing in one direction
void state_page_unit(RawDrawing& drawing, const SvgElement& root);

} // namespace app
