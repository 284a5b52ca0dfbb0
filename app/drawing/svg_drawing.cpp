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
    SvgNodes nodes;
    std::vector<SvgGroup> groups;
    std::vector<std::size_t> cloned; ///< elements that are being read as clones
    std::size_t clones = 0;          ///< elements that were read within clones
    std::map<std::string, std::size_t> ignored;
    HiddenShapes hidden;
    std::size_t clipped = 0;      ///< outlines of which only a part is shown
    std::vector<SvgPaint> paints; ///< of the outlines of the drawing
    SvgStyleSheet sheet;
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
    if (content.drawing.outlines.size() > content.paints.size())
        content.paints.push_back({group.has_fill(), group.has_stroke()});
}

void add_rectangle(SvgContent& content, const SvgElement& element, const SvgGroup& group)
{
    const double x = element.length("x"), y = element.length("y");
    const double width = element.length("width"), height = element.length("height");
    if (width < 0.0 || height < 0.0) {
        refuse(content.drawing.frame, element.place.line,
               "the rectangle at (" + number(x, 8) + ", " + number(y, 8) +
                   ") has a negative width or height, and no program draws it; make it "
                   "positive or delete it");
    }
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

/// A background of the page as web pages have it.
bool is_page(const SvgElement& element)
{
    const char *width = element.find("width"), *height = element.find("height");
    return element.name == "rect" && width && height && without_blanks(width) == "100%" &&
           without_blanks(height) == "100%";
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

/// The element that a clone repeats.
std::size_t original_of(const SvgContent& content, const SvgElement& use)
{
    const auto refused = [&](const std::string& why) {
        refuse(content.drawing.frame, use.place.line,
               "a clone (use) " + why + "; unlink it, so that its outline is in the drawing");
    };
    const char* link = use.find("href");
    if (link == nullptr) link = use.find("xlink:href");
    const std::string_view text = link ? without_blanks(link) : "";
    if (!text.starts_with('#')) refused("does not name an element of this file");
    const auto found = content.nodes.by_id.find(std::string(text.substr(1)));
    if (found == content.nodes.by_id.end())
        refused("repeats \"" + readable_name(text.substr(0, 40)) + "\", which is not there");
    if (std::ranges::find(content.cloned, found->second) != content.cloned.end())
        refused("repeats itself");
    const SvgNode& original = content.nodes.all[found->second];
    const SvgElement element{original.name, original.attributes, use.place};
    for (const char* name : {"viewBox", "refX", "refY"})
        if (original.name == "symbol" && element.find(name) != nullptr)
            refused("repeats a symbol that has a " + std::string(name) + ", which is not read");
    return found->second;
}

void read_within(SvgContent& content, std::size_t begin, std::size_t end);

/// Reads an element again, at the place of its clone.
void add_clone(SvgContent& content, const SvgElement& use, SvgGroup group)
{
    const std::size_t original = original_of(content, use);
    group.transform =
        group.transform * PlaneTransform{1, 0, 0, 1, use.length("x"), use.length("y")};
    begin_group(content, use, std::move(group));
    content.cloned.push_back(original);
    read_within(content, original, content.nodes.all[original].end);
    content.cloned.pop_back();
    content.groups.pop_back();
}

bool is_group(const SvgContent& content, std::size_t place, std::string_view name)
{
    const bool original = !content.cloned.empty() && content.cloned.back() == place;
    return name == "g" || name == "a" || name == "switch" || (name == "symbol" && original);
}

/// Reads an element that is no group.
void add_element(SvgContent& content, const SvgElement& element)
{
    constexpr std::array<std::string_view, 14> kSilent = {
        "defs",   "title",  "desc", "metadata", "style",  "script",         "clipPath",
        "marker", "symbol", "mask", "pattern",  "filter", "linearGradient", "radialGradient"};
    const std::string_view name = element.name;
    if (name.find(':') != std::string_view::npos)
        return; // of the drawing program, such as sodipodi:namedview
    if (std::ranges::find(kSilent, name) != kSilent.end()) return;
    SvgGroup group = group_within(content.groups.back(), content.sheet, element);
    if (count_hidden(content, element, group)) return;
    if (is_page(element)) {
        ++content.ignored["page"];
        return;
    }
    if (name == "use") return add_clone(content, element, std::move(group));
    if (add_shape(content, element, group)) {
        content.clipped += group.clipped ? 1 : 0;
        return;
    }
    refuse_shape(content, element, group);
    ++content.ignored[readable_name(name.substr(0, 40))];
}

/// Elements from `begin` on, and what lies within groups among them.
void read_within(SvgContent& content, std::size_t begin, std::size_t end)
{
    constexpr std::size_t kMostClones = 100'000; // clones of clones of clones
    for (std::size_t i = begin; i < end; i = content.nodes.all[i].end) {
        const SvgNode& node = content.nodes.all[i];
        const SvgElement element{
            node.name, node.attributes, {&content.drawing.frame, node.line}};
        if (!content.cloned.empty() && ++content.clones > kMostClones)
            refuse(content.drawing.frame, node.line,
                   "clones (use) repeat more than 100000 elements; no drawing needs that");
        if (!is_group(content, i, node.name)) {
            add_element(content, element);
            continue;
        }
        begin_group(content, element,
                    group_within(content.groups.back(), content.sheet, element));
        const auto [first, last] = node.name == "switch" ? drawn_of_switch(content.nodes, i)
                                                         : std::pair{i + 1, node.end};
        read_within(content, first, last);
        content.groups.pop_back();
    }
}

/// The whole file: an element svg, and what lies within it.
void read_nodes(SvgContent& content)
{
    if (content.nodes.all.empty()) return;
    const SvgNode& root = content.nodes.all.front();
    const SvgElement element{root.name, root.attributes, {&content.drawing.frame, root.line}};
    if (root.name != "svg")
        refuse(content.drawing.frame, root.line,
               "is not SVG: it begins with <" +
                   readable_name(std::string_view(root.name).substr(0, 40)) + ">");
    state_page_unit(content.drawing, element);
    begin_group(content, element, group_within({}, content.sheet, element));
    read_within(content, 1, root.end);
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

} // namespace

RawDrawing read_svg(const DrawingFrame& frame, std::string_view bytes, double snap)
{
    SvgContent content;
    content.drawing.frame = frame;
    content.snap = snap;
    content.sheet = svg_sheets(frame, bytes);
    content.nodes = svg_nodes(bytes);
    read_nodes(content);
    if (!content.nodes.error.empty()) {
        refuse(frame, content.nodes.error_line,
               "is not XML (" + content.nodes.error + "); export the drawing again");
    }
    join_paints(content.drawing, content.paints, snap);
    note_ignored(content.drawing, content.ignored);
    note_hidden(content.drawing, content.hidden);
    note_clipped(content);
    return std::move(content.drawing);
}

} // namespace app
