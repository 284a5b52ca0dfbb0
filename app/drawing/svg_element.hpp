#pragma once
/// An element of an SVG drawing, and what it hands down to those within it.

#include "app/drawing/svg_geometry.hpp"
#include "app/drawing/svg_sheet.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace app {

/// Properties that an element hands down to those within it.
struct SvgGroup {
    PlaneTransform transform;
    std::string label, id;               ///< of the innermost group that has one
    bool displayed = true;               ///< display, which hides all that lies within
    bool visible = true;                 ///< visibility, which what lies within may set anew
    bool clipped = false;                ///< by a clip path or a mask
    bool filled = true, stroked = false; ///< paint, which what lies within may set anew
    /// Opacity of the fill, and opacity and width of the stroke, are not zero; as paint.
    bool fill_shows = true, stroke_shows = true, stroke_is_wide = true;

    [[nodiscard]] bool shown() const { return displayed && visible; }
    [[nodiscard]] bool has_fill() const { return filled && fill_shows; }
    [[nodiscard]] bool has_stroke() const { return stroked && stroke_shows && stroke_is_wide; }
    [[nodiscard]] const std::string& layer() const { return label.empty() ? id : label; }
};

struct SvgElement {
    std::string_view name;
    std::span<const std::string> attributes; ///< names, each with its value behind it
    SvgPlace place;

    /// A null pointer if it has no such attribute.
    [[nodiscard]] const char* find(std::string_view wanted) const
    {
        for (std::size_t a = 0; a + 1 < attributes.size(); a += 2)
            if (wanted == attributes[a]) return attributes[a + 1].c_str();
        return nullptr;
    }
    [[nodiscard]] double length(std::string_view wanted) const
    {
        const char* text = find(wanted);
        return text ? svg_length(place, wanted, text) : 0.0;
    }
};

/// Properties that `around` hands down, with the transform of the element and whether it is
/// shown.
/// @throws ConfigError
[[nodiscard]] SvgGroup group_within(SvgGroup around, const SvgStyleSheet& sheet,
                                    const SvgElement& element);

} // namespace app
