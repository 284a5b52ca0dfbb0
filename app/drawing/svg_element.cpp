#include "app/drawing/svg_element.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/text/words.hpp"

namespace app {
namespace {

/// Style that the element itself states: its attributes, replaced by style sheets and those by
/// its style; what is important comes last, in the same order.
SvgStyle style_of(const SvgStyleSheet& sheet, const SvgElement& element)
{
    SvgStyle style;
    const auto text_of = [&](const char* name) -> std::string_view {
        const char* value = element.find(name);
        return value ? value : "";
    };
    for (const char* name : {"display", "visibility", "opacity", "fill", "stroke",
                             "fill-opacity", "stroke-opacity", "stroke-width", "transform",
                             "transform-origin", "clip-path", "mask"})
        if (const char* value = element.find(name)) style[name] = value;
    for (const Importance of : {Importance::usual, Importance::important}) {
        sheet.apply(style, of, element.name, text_of("id"), text_of("class"));
        add_declarations(style, text_of("style"), of);
    }
    return style;
}

/// Properties of CSS that move an element besides its transform.
void refuse_other_moves(const SvgElement& element, const SvgStyle& style)
{
    for (const char* name : {"translate", "rotate", "scale"}) {
        const auto at = style.find(name);
        if (at == style.end() || at->second == "none") continue;
        refuse(*element.place.frame, element.place.line,
               "the style has \"" + std::string(name) +
                   "\", which is not read; apply the transforms in the drawing program");
    }
}

/// Properties of CSS that make the shape of an element.
void refuse_shapes(const SvgElement& element, const SvgStyle& style)
{
    if (element.name != "rect" && element.name != "path" && element.name != "use") return;
    for (const char* name : {"x", "y", "width", "height", "rx", "ry", "d"}) {
        if (!style.contains(name)) continue;
        refuse(*element.place.frame, element.place.line,
               "the style has \"" + std::string(name) +
                   "\", which is not read; write it as an attribute of the " +
                   std::string(element.name));
    }
}

PlaneTransform transform_of(const SvgElement& element, const SvgStyle& style)
{
    refuse_other_moves(element, style);
    const auto at = style.find("transform");
    if (at == style.end() || at->second == "none") return {};
    const std::string plain = plain_transform(at->second);
    const auto origin = style.find("transform-origin");
    const bool elsewhere = origin != style.end() &&
                           origin->second.find_first_of("123456789%") != std::string::npos;
    if (plain.empty() || elsewhere) {
        refuse(*element.place.frame, element.place.line,
               "the transform \"" + readable_name(at->second.substr(0, 40)) +
                   "\" of a style has units or an origin that are not read; apply the "
                   "transforms in the drawing program");
    }
    return svg_transform(element.place, plain);
}

/// Whether a number that may be inherited, such as "stroke-width", is not zero.
bool is_not_zero(std::string_view value, bool around)
{
    if (value.empty() || value == "inherit") return around;
    const std::size_t end = value.find_first_not_of("+-.0123456789eE");
    return read_number(value.substr(0, end)) != 0.0;
}

/// Whether a colour is clear: #rrggbb00, rgba(0, 0, 0, 0), rgb(0 0 0 / 0%).
bool is_clear(std::string_view colour)
{
    if (colour.starts_with('#'))
        return (colour.size() == 5 && colour[4] == '0') ||
               (colour.size() == 9 && colour.substr(7) == "00");
    const std::size_t open = colour.find('(');
    if (open == std::string_view::npos || colour.starts_with("url")) return false;
    std::string_view inside = colour.substr(open + 1, colour.find(')') - open - 1);
    const std::size_t slash = inside.find('/');
    if (slash != std::string_view::npos)
        return !is_not_zero(without_blanks(inside.substr(slash + 1)), true);
    const auto parts = style_parts(inside, ',');
    return parts.size() == 4 && !is_not_zero(parts[3], true);
}

/// Whether a paint is seen, of a property "fill" or "stroke" that may be inherited.
bool is_painted(std::string_view text, bool around)
{
    const std::string paint = lower_case(text);
    if (paint.empty() || paint == "inherit") return around;
    return paint != "none" && paint != "transparent" && !is_clear(paint);
}

} // namespace

SvgGroup group_within(SvgGroup group, const SvgStyleSheet& sheet, const SvgElement& element)
{
    const SvgStyle style = style_of(sheet, element);
    refuse_shapes(element, style);
    group.transform = group.transform * transform_of(element, style);
    const auto value = [&](const char* name) -> std::string_view {
        const auto at = style.find(name);
        return at == style.end() ? "" : std::string_view(at->second);
    };
    if (value("display") == "none" || !is_not_zero(value("opacity"), true))
        group.displayed = false;
    for (const char* name : {"clip-path", "mask"})
        if (!value(name).empty() && value(name) != "none") group.clipped = true;
    group.filled = is_painted(value("fill"), group.filled);
    group.stroked = is_painted(value("stroke"), group.stroked);
    group.fill_shows = is_not_zero(value("fill-opacity"), group.fill_shows);
    group.stroke_shows = is_not_zero(value("stroke-opacity"), group.stroke_shows);
    group.stroke_is_wide = is_not_zero(value("stroke-width"), group.stroke_is_wide);
    const std::string_view visibility = value("visibility");
    if (visibility == "hidden" || visibility == "collapse") group.visible = false;
    if (visibility == "visible") group.visible = true;
    return group;
}

} // namespace app
