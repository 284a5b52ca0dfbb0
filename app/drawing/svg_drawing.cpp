#include "app/drawing/outlines/drawing_formats.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/drawing/outlines/hidden_layers.hpp"
#include "app/drawing/svg_element.hpp"
#include "app/drawing/svg_geometry.hpp"
#include "app/drawing/svg_paints.hpp"
#include "app/drawing/svg_reading.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace app {
namespace {

constexpr std::size_t kDeepestGroup = 256; // groups within groups

struct SvgContent {
    RawDrawing drawing;
    double snap = 0.0;
    XML_Parser parser = nullptr;
    std::vector<SvgGroup> groups;
    std::size_t skipped = 0; ///< depth within an element that is passed over
    std::map<std::string, std::size_t> ignored;
    HiddenShapes hidden;
    std::size_t clipped = 0;      ///< outlines of which only a part is shown
    std::vector<SvgPaint> paints; ///< of the outlines of the drawing
    SvgStyleSheet sheet;
    std::exception_ptr error; ///< kept while the parser, which is C, returns
};

dem::Point placed(const SvgContent& content, const SvgElement& element,
                  const PlaneTransform& transform, SvgPoint p)
{
    const SvgPoint at = apply(transform, p);
    return checked_point(content.drawing.frame, element.place.line, at.x, -at.y);
}

void add_polygon(SvgContent& content, const SvgElement& element, const SvgGroup& group,
                 const std::vector<SvgPoint>& points, bool closed)
{
    RawOutline outline{{}, group.layer(), element.place.line};
    for (const SvgPoint& p : points)
        outline.corners.push_back(placed(content, element, group.transform, p));
    add_outline(content.drawing, std::move(outline), closed, content.snap);
    content.paints.push_back({group.has_fill(), group.has_stroke()});
}

void add_rectangle(SvgContent& content, const SvgElement& element, const SvgGroup& group)
{
    const double x = element.length("x"), y = element.length("y");
    const double width = element.length("width"), height = element.length("height");
    if (element.length("rx") != 0.0 || element.length("ry") != 0.0) {
        refuse(content.drawing.frame, element.place.line,
               "the rectangle at (" + number(x, 8) + ", " + number(y, 8) +
                   ") has rounded corners; set rx and ry to 0");
    }
    add_polygon(content, element, group,
                {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}, true);
}

void add_svg_line(SvgContent& content, const SvgElement& element, const SvgGroup& group)
{
    const auto end = [&](const char* x, const char* y) {
        return placed(content, element, group.transform,
                      {element.length(x), element.length(y)});
    };
    add_line(content.drawing,
             {end("x1", "y1"), end("x2", "y2"), group.layer(), element.place.line});
}

/// True if the element draws; what lies within it is then passed over.
bool add_shape(SvgContent& content, const SvgElement& element, const SvgGroup& group)
{
    const auto text = [&](const char* attribute) -> std::string_view {
        const char* found = element.find(attribute);
        return found ? found : "";
    };
    if (element.name == "path") {
        for (const SvgSubpath& path : svg_path(element.place, text("d")))
            if (path.points.size() > 1)
                add_polygon(content, element, group, path.points, path.closed);
    } else if (element.name == "polygon") {
        add_polygon(content, element, group, svg_points(element.place, text("points")), true);
    } else if (element.name == "polyline") {
        add_polygon(content, element, group, svg_points(element.place, text("points")), false);
    } else if (element.name == "rect") {
        add_rectangle(content, element, group);
    } else if (element.name == "line") {
        add_svg_line(content, element, group);
    } else {
        return false;
    }
    return true;
}

void refuse_shape(const SvgContent& content, const SvgElement& element, const SvgGroup& group)
{
    const auto at = [&](std::string_view x, std::string_view y) {
        return raw_coordinates(
            content.drawing.frame,
            placed(content, element, group.transform, {element.length(x), element.length(y)}));
    };
    if (element.name == "circle" || element.name == "ellipse") {
        refuse(content.drawing.frame, element.place.line,
               "at " + at("cx", "cy") + " there is a " + std::string(element.name) +
                   "; convert it to a path of straight pieces");
    }
    if (element.name == "use") {
        refuse(content.drawing.frame, element.place.line,
               "at " + at("x", "y") +
                   " there is a clone (use); unlink it, so that its outline is in the drawing "
                   "itself");
    }
    if (element.name == "svg") {
        refuse(content.drawing.frame, element.place.line,
               "has a drawing within the drawing (svg); ungroup it");
    }
}

/// Frames without fill and stroke, which drawing programs lay around shapes and pages. A line
/// has no fill; the file of a line without a stroke was written by hand.
bool is_unpainted(const SvgElement& element, const SvgGroup& group)
{
    return !group.has_fill() && !group.has_stroke() && element.name != "line" &&
           element.name != "use";
}

/// True for a shape that is not shown, or whose group is not.
bool count_hidden(SvgContent& content, const SvgElement& element, const SvgGroup& group)
{
    constexpr std::array<std::string_view, 8> kShapes = {"path", "polygon", "polyline", "rect",
                                                         "line", "circle",  "ellipse",  "use"};
    const bool is_shape = std::ranges::find(kShapes, element.name) != kShapes.end();
    if (group.shown() && !(is_shape && is_unpainted(element, group))) return false;
    if (!is_shape) return true;
    const SvgGroup& around = content.groups.back();
    if (around.shown())
        ++content.hidden.alone;
    else
        ++content.hidden.on_layers[around.layer()];
    return true;
}

void begin_group(SvgContent& content, const SvgElement& element, SvgGroup group)
{
    if (content.groups.size() >= kDeepestGroup) {
        refuse(content.drawing.frame, element.place.line,
               "groups are nested more than 256 deep; no drawing needs that");
    }
    if (element.name == "g") {
        const char *label = element.find("inkscape:label"), *id = element.find("id");
        if (label) group.label = readable_name(label);
        if (id) group.id = readable_name(id);
    }
    content.groups.push_back(std::move(group));
}

void begin_element(SvgContent& content, std::string_view name, const XML_Char** attributes)
{
    constexpr std::array<std::string_view, 14> kSilent = {
        "defs",   "title",  "desc", "metadata", "style",  "script",         "clipPath",
        "marker", "symbol", "mask", "pattern",  "filter", "linearGradient", "radialGradient"};
    if (name.starts_with("svg:")) name.remove_prefix(4);
    if (content.skipped > 0) {
        ++content.skipped;
        return;
    }
    const SvgElement element{
        name,
        attributes,
        {&content.drawing.frame, static_cast<int>(XML_GetCurrentLineNumber(content.parser))}};
    if (content.groups.empty()) {
        if (name != "svg")
            refuse(content.drawing.frame, element.place.line,
                   "is not SVG: it begins with <" + readable_name(name.substr(0, 40)) + ">");
        state_page_unit(content.drawing, element);
        return begin_group(content, element, group_within({}, content.sheet, element));
    }
    if (name == "g" || name == "a" || name == "switch")
        return begin_group(content, element,
                           group_within(content.groups.back(), content.sheet, element));
    content.skipped = 1;
    if (name.find(':') != std::string_view::npos)
        return; // of the drawing program, such as sodipodi:namedview
    if (std::ranges::find(kSilent, name) != kSilent.end()) return;
    const SvgGroup group = group_within(content.groups.back(), content.sheet, element);
    if (count_hidden(content, element, group)) return;
    if (add_shape(content, element, group)) {
        content.clipped += group.clipped ? 1 : 0;
        return;
    }
    refuse_shape(content, element, group);
    ++content.ignored[readable_name(name.substr(0, 40))];
}

void note_clipped(SvgContent& content)
{
    if (content.clipped == 0) return;
    const bool one = content.clipped == 1;
    content.drawing.notes.push_back(counted(content.clipped, "shape has", "shapes have") +
                                    " a clip path or a mask, which " + (one ? "is" : "are") +
                                    " not read: " + (one ? "its" : "their") +
                                    " whole outlines count.");
}

void XMLCALL on_begin(void* data, const XML_Char* name, const XML_Char** attributes)
{
    SvgContent& content = *static_cast<SvgContent*>(data);
    if (content.error) return;
    try {
        begin_element(content, name, attributes);
    } catch (...) {
        content.error = std::current_exception();
        XML_StopParser(content.parser, XML_FALSE);
    }
}

void XMLCALL on_end(void* data, const XML_Char*)
{
    SvgContent& content = *static_cast<SvgContent*>(data);
    if (content.skipped > 0)
        --content.skipped;
    else if (!content.groups.empty())
        content.groups.pop_back();
}

} // namespace

RawDrawing read_svg(const DrawingFrame& frame, std::string_view bytes, double snap)
{
    SvgContent content;
    content.drawing.frame = frame;
    content.snap = snap;
    content.sheet = svg_sheets(frame, bytes);
    const SvgParser parser = svg_parser();
    content.parser = parser.get();
    XML_SetUserData(parser.get(), &content);
    XML_SetElementHandler(parser.get(), on_begin, on_end);
    const XML_Status status =
        XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE);
    if (content.error) std::rethrow_exception(content.error);
    if (status != XML_STATUS_OK) {
        refuse(frame, static_cast<int>(XML_GetCurrentLineNumber(parser.get())),
               "is not XML (" + std::string(XML_ErrorString(XML_GetErrorCode(parser.get()))) +
                   "); export the drawing again");
    }
    join_paints(content.drawing, content.paints, snap);
    note_ignored(content.drawing, content.ignored);
    note_hidden(content.drawing, content.hidden);
    note_clipped(content);
    return std::move(content.drawing);
}

} // namespace app
