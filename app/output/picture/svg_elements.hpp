#pragma once
/// The few SVG elements the pictures are made of. Coordinates in pixels, y downwards.

#include <span>
#include <string>
#include <string_view>

namespace app {

struct Pixel {
    double x = 0.0, y = 0.0;
};

/// Text with & < > " ' escaped; control characters, which XML forbids, become spaces.
[[nodiscard]] std::string xml_escape(std::string_view text);

/// Two decimals. Throws std::invalid_argument for NaN and infinities: no picture shows them.
[[nodiscard]] std::string svg_number(double value);

/// name="value" and a blank; `value` is not escaped.
[[nodiscard]] std::string svg_attribute(std::string_view name, std::string_view value);
/// A line of `width` pixels without fill, as attributes.
[[nodiscard]] std::string svg_stroke(std::string_view colour, double width);
/// Elements that share attributes; empty if there are none.
[[nodiscard]] std::string svg_group(std::string_view style, std::string_view elements);

/// `style` holds attributes, e.g. stroke="#333". Elements end with a newline.
[[nodiscard]] std::string svg_polygon(std::span<const Pixel> points, std::string_view style);
[[nodiscard]] std::string svg_polyline(std::span<const Pixel> points, std::string_view style);
[[nodiscard]] std::string svg_dot(Pixel centre, double radius, std::string_view style);
[[nodiscard]] std::string svg_line(Pixel a, Pixel b, std::string_view style);
[[nodiscard]] std::string svg_rectangle(Pixel top_left, double width, double height,
                                        std::string_view style);
/// `text` is escaped here; nothing where it is empty.
[[nodiscard]] std::string svg_text(Pixel at, std::string_view text, std::string_view style);

/// `elements`, cut off outside a rectangle; coordinates stay those of the page. Without ids:
/// several pictures fit in one page.
[[nodiscard]] std::string svg_window(Pixel top_left, double width, double height,
                                     std::string_view elements);

/// A whole file around `body`: white page, one sans-serif font, 13 px unless said otherwise.
/// @param title for screen readers and tooltips, escaped here; may be empty
[[nodiscard]] std::string svg_page(double width, double height, std::string_view title,
                                   std::string_view body);

/// Width of `text` in pixels in a sans-serif font of `size` px, on the safe side.
[[nodiscard]] double text_width(std::string_view text, double size);

} // namespace app
