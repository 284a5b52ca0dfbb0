#include "app/output/picture/svg_elements.hpp"

#include "app/output/picture/markup.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace app {

namespace {

std::string element(std::string_view name, std::string_view geometry, std::string_view style)
{
    std::string text = "<";
    text.append(name).append(geometry);
    if (!style.empty()) text.append(" ").append(style);
    return text + "/>\n";
}

std::string attribute(std::string_view name, double value)
{
    std::string text = " ";
    return text.append(name).append("=\"") + svg_number(value) + '"';
}

std::string points_attribute(std::span<const Pixel> points)
{
    std::string text = " points=\"";
    for (const Pixel& p : points) text += svg_number(p.x) + ',' + svg_number(p.y) + ' ';
    text.back() = '"';
    return text;
}

} // namespace

std::string xml_escape(std::string_view text)
{
    constexpr Replacement kXml[] = {
        {"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"'", "&apos;"}};
    std::string result = replaced(text, kXml);
    std::ranges::replace_if(
        result, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
    return result;
}

std::string svg_number(double value)
{
    if (!std::isfinite(value))
        throw std::invalid_argument("picture: a coordinate is not finite");
    std::string text = fixed(value, 2);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string svg_attribute(std::string_view name, std::string_view value)
{
    std::string text(name);
    return text.append("=\"").append(value).append("\" ");
}

std::string svg_stroke(std::string_view colour, double width)
{
    return "fill=\"none\" " + svg_attribute("stroke", colour) +
           svg_attribute("stroke-width", svg_number(width));
}

std::string svg_group(std::string_view style, std::string_view elements)
{
    if (elements.empty()) return {};
    std::string text = "<g ";
    return text.append(style).append(">\n").append(elements) + "</g>\n";
}

std::string svg_polygon(std::span<const Pixel> points, std::string_view style)
{
    return points.empty() ? "" : element("polygon", points_attribute(points), style);
}

std::string svg_polyline(std::span<const Pixel> points, std::string_view style)
{
    return points.empty() ? "" : element("polyline", points_attribute(points), style);
}

std::string svg_dot(Pixel centre, double radius, std::string_view style)
{
    return element(
        "circle",
        attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius), style);
}

std::string svg_line(Pixel a, Pixel b, std::string_view style)
{
    return element("line",
                   attribute("x1", a.x) + attribute("y1", a.y) + attribute("x2", b.x) +
                       attribute("y2", b.y),
                   style);
}

std::string svg_rectangle(Pixel top_left, double width, double height, std::string_view style)
{
    return element("rect",
                   attribute("x", top_left.x) + attribute("y", top_left.y) +
                       attribute("width", width) + attribute("height", height),
                   style);
}

std::string svg_text(Pixel at, std::string_view text, std::string_view style)
{
    if (text.empty()) return {};
    std::string result = "<text" + attribute("x", at.x) + attribute("y", at.y);
    if (!style.empty()) result.append(" ").append(style);
    return result + '>' + xml_escape(text) + "</text>\n";
}

std::string svg_window(Pixel top_left, double width, double height, std::string_view elements)
{
    const std::string box = svg_number(top_left.x) + ' ' + svg_number(top_left.y) + ' ' +
                            svg_number(width) + ' ' + svg_number(height);
    std::string text = "<svg" + attribute("x", top_left.x) + attribute("y", top_left.y) +
                       attribute("width", width) + attribute("height", height) + " viewBox=\"" +
                       box + "\">\n";
    return text.append(elements) + "</svg>\n";
}

std::string svg_page(double width, double height, std::string_view title, std::string_view body)
{
    const std::string w = svg_number(width), h = svg_number(height);
    std::string page =
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
        "\" viewBox=\"0 0 " + w + ' ' + h +
        "\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" font-size=\"13\" "
        "fill=\"#222\">\n" +
        (title.empty() ? std::string() : "<title>" + xml_escape(title) + "</title>\n") +
        svg_rectangle({0, 0}, width, height, "fill=\"white\"");
    return page.append(body) + "</svg>\n";
}

double text_width(std::string_view text, double size)
{
    int characters = 0;
    for (const char c : text) characters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    return 0.62 * size *
           characters; // mean of DejaVu Sans, a wide font, in lower case and digits
}

} // namespace app
