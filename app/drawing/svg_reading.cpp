#include "app/drawing/svg_reading.hpp"

#include "app/drawing/outlines/drawing_file.hpp"
#include "app/text/words.hpp"

#include <expat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace app {
namespace {

using SvgParser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)>;

SvgParser svg_parser()
{
    SvgParser parser(XML_ParserCreate(nullptr), XML_ParserFree);
    if (!parser) throw std::bad_alloc();
    return parser;
}

struct NodeReading {
    XML_Parser parser = nullptr;
    SvgNodes nodes;
    std::vector<std::size_t> open;
    std::vector<std::string> prefixes = {"svg:"}; ///< of elements of SVG
    std::exception_ptr error; ///< kept while the parser, which is C, returns
};

void add_node(NodeReading& reading, std::string_view name, const XML_Char** attributes)
{
    constexpr std::string_view kDeclares = "xmlns:";
    for (const XML_Char** a = attributes; *a != nullptr; a += 2)
        if (std::string_view(a[0]).starts_with(kDeclares) &&
            std::string_view(a[1]) == "http://www.w3.org/2000/svg")
            reading.prefixes.push_back(a[0] + kDeclares.size() + std::string(":"));
    const auto prefix = std::ranges::find_if(
        reading.prefixes, [&](const std::string& p) { return name.starts_with(p); });
    if (prefix != reading.prefixes.end()) name.remove_prefix(prefix->size());
    SvgNode node{std::string(name), {}, 0, 0};
    node.line = static_cast<int>(XML_GetCurrentLineNumber(reading.parser));
    const std::size_t place = reading.nodes.all.size();
    for (const XML_Char** a = attributes; *a != nullptr; ++a) node.attributes.emplace_back(*a);
    for (std::size_t a = 0; a + 1 < node.attributes.size(); a += 2)
        if (node.attributes[a] == "id")
            reading.nodes.by_id.emplace(node.attributes[a + 1], place);
    reading.nodes.all.push_back(std::move(node));
    reading.open.push_back(place);
}

void XMLCALL on_node_begin(void* data, const XML_Char* name, const XML_Char** attributes)
{
    NodeReading& reading = *static_cast<NodeReading*>(data);
    if (reading.error) return;
    try {
        add_node(reading, name, attributes);
    } catch (...) {
        reading.error = std::current_exception();
        XML_StopParser(reading.parser, XML_FALSE);
    }
}

void XMLCALL on_node_end(void* data, const XML_Char*)
{
    NodeReading& reading = *static_cast<NodeReading*>(data);
    if (reading.error || reading.open.empty()) return;
    reading.nodes.all[reading.open.back()].end = reading.nodes.all.size();
    reading.open.pop_back();
}

struct SheetReading {
    XML_Parser parser = nullptr;
    SvgStyleSheet sheet;
    std::string text;
    bool in_sheet = false;
    std::string unread; ///< the first selector that is not read, though it matters
    int unread_line = 0;
};

void XMLCALL on_sheet_begin(void* data, const XML_Char* name, const XML_Char**)
{
    const std::string_view element = name;
    static_cast<SheetReading*>(data)->in_sheet =
        element == "style" || element.ends_with(":style");
}

void XMLCALL on_sheet_text(void* data, const XML_Char* text, int length)
{
    SheetReading& reading = *static_cast<SheetReading*>(data);
    if (reading.in_sheet) reading.text.append(text, static_cast<std::size_t>(length));
}

void XMLCALL on_sheet_end(void* data, const XML_Char*)
{
    SheetReading& reading = *static_cast<SheetReading*>(data);
    if (!std::exchange(reading.in_sheet, false)) return;
    const std::string unread = reading.sheet.add(std::exchange(reading.text, {}));
    if (unread.empty() || !reading.unread.empty()) return;
    reading.unread = unread;
    reading.unread_line = static_cast<int>(XML_GetCurrentLineNumber(reading.parser));
}

/// Length of a page in metres; nothing if it is not given as a length.
std::optional<double> page_length(const char* attribute)
{
    if (attribute == nullptr) return {};
    const std::string small = lower_case(without_blanks(attribute));
    const std::string_view text = small;
    const std::size_t digits = std::min(text.find_first_not_of("0123456789.+-e"), text.size());
    std::size_t end = digits; // "1em" is not 1e
    while (end > 0 && text[end - 1] == 'e') --end;
    constexpr std::array<std::pair<std::string_view, double>, 7> kLengths = {
        {{"mm", 1e-3},
         {"cm", 1e-2},
         {"m", 1.0},
         {"in", 0.0254},
         {"pt", 0.0254 / 72.0},
         {"pc", 0.0254 / 6.0},
         {"q", 0.25e-3}}};
    const auto known = std::ranges::find_if(
        kLengths, [&](const auto& u) { return u.first == text.substr(end); });
    const std::optional<double> number = read_number(text.substr(0, end));
    if (known == kLengths.end() || !number || *number <= 0.0) return {};
    return *number * known->second;
}

bool is_in_pixels(const char* width)
{
    return width != nullptr && without_blanks(width).ends_with("px");
}

} // namespace

SvgNodes svg_nodes(std::string_view bytes)
{
    NodeReading reading;
    const SvgParser parser = svg_parser();
    reading.parser = parser.get();
    XML_SetUserData(parser.get(), &reading);
    XML_SetElementHandler(parser.get(), on_node_begin, on_node_end);
    const XML_Status status =
        XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE);
    if (reading.error) std::rethrow_exception(reading.error);
    for (const std::size_t open : reading.open)
        reading.nodes.all[open].end = reading.nodes.all.size();
    if (status != XML_STATUS_OK) {
        reading.nodes.error_line = static_cast<int>(XML_GetCurrentLineNumber(parser.get()));
        reading.nodes.error = XML_ErrorString(XML_GetErrorCode(parser.get()));
    }
    return std::move(reading.nodes);
}

std::pair<std::size_t, std::size_t> drawn_of_switch(const SvgNodes& nodes, std::size_t at)
{
    const std::size_t end = nodes.all[at].end;
    const auto has_condition = [](const SvgNode& node) {
        constexpr std::array<std::string_view, 3> kConditions = {
            "requiredExtensions", "requiredFeatures", "systemLanguage"};
        for (std::size_t a = 0; a + 1 < node.attributes.size(); a += 2)
            if (std::ranges::find(kConditions, node.attributes[a]) != kConditions.end())
                return true;
        return false;
    };
    std::size_t i = at + 1;
    while (i < end && has_condition(nodes.all[i])) i = nodes.all[i].end;
    return {i, i < end ? nodes.all[i].end : end};
}

SvgStyleSheet svg_sheets(const DrawingFrame& frame, std::string_view bytes)
{
    SheetReading reading;
    const SvgParser parser = svg_parser();
    reading.parser = parser.get();
    XML_SetUserData(parser.get(), &reading);
    XML_SetElementHandler(parser.get(), on_sheet_begin, on_sheet_end);
    XML_SetCharacterDataHandler(parser.get(), on_sheet_text);
    // what is not XML is refused when the shapes are read
    static_cast<void>(
        XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE));
    if (!reading.unread.empty())
        refuse(frame, reading.unread_line,
               "the style sheet hides or moves what \"" +
                   readable_name(reading.unread.substr(0, 60)) +
                   "\" selects, which is not read; give the shapes a class or a style of their "
                   "own");
    return std::move(reading.sheet);
}

void state_page_unit(RawDrawing& drawing, const SvgElement& root)
{
    const char *width = root.find("width"), *box = root.find("viewBox");
    if (box == nullptr) return;
    if (is_in_pixels(width))
        drawing.notes.emplace_back("The file gives its width in px, which are not lengths.");
    const std::vector<SvgPoint> corners = svg_points(root.place, box);
    if (corners.size() != 2 || !(corners[1].x > 0.0) || !(corners[1].y > 0.0)) return;
    const std::optional<double> across = page_length(width),
                                up = page_length(root.find("height"));
    if (!across && !up) return;
    const double x = across ? *across / corners[1].x : *up / corners[1].y;
    const double y = up ? *up / corners[1].y : x;
    const char* fit = root.find("preserveAspectRatio");
    const std::string_view how = fit ? without_blanks(fit) : "";
    if (how.starts_with("none") && std::abs(x / y - 1.0) > 1e-3)
        refuse(
            *root.place.frame, root.place.line,
            "preserveAspectRatio=\"none\" stretches the drawing: width and height of the page "
            "are not those of the viewBox; make them alike");
    state_unit(drawing, how.ends_with("slice") ? std::max(x, y) : std::min(x, y), "");
}

} // namespace app
