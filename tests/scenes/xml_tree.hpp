#pragma once
/// Reads pictures and files back as XML, so that tests ask for elements and not for text.

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace scenes {

using Xml = boost::property_tree::ptree;

/// Throws if `text` is not well-formed.
[[nodiscard]] inline Xml parse_xml(const std::string& text)
{
    std::istringstream in(text);
    Xml tree;
    boost::property_tree::read_xml(in, tree);
    return tree;
}

/// A drawing without a page around it.
[[nodiscard]] inline Xml parse_elements(const std::string& elements)
{
    return parse_xml("<g>" + elements + "</g>");
}

/// All elements called `name`, in order, however deep.
[[nodiscard]] inline std::vector<Xml> elements(const Xml& tree, const std::string& name)
{
    std::vector<Xml> found;
    for (const auto& [key, child] : tree) {
        if (key == name) found.push_back(child);
        for (Xml& deeper : elements(child, name)) found.push_back(std::move(deeper));
    }
    return found;
}

[[nodiscard]] inline std::string attribute(const Xml& element, const std::string& name)
{
    return element.get("<xmlattr>." + name, std::string());
}

[[nodiscard]] inline double number_of(const Xml& element, const std::string& name)
{
    return element.get<double>("<xmlattr>." + name);
}

/// The points of a polygon or poly-line.
[[nodiscard]] inline std::vector<std::pair<double, double>> points_of(const Xml& element)
{
    std::istringstream in(attribute(element, "points"));
    std::vector<std::pair<double, double>> points;
    double x = 0.0, y = 0.0;
    char comma = ' ';
    while (in >> x >> comma >> y) points.emplace_back(x, y);
    return points;
}

/// Texts of all text elements.
[[nodiscard]] inline std::vector<std::string> texts(const Xml& tree)
{
    std::vector<std::string> found;
    for (const Xml& element : elements(tree, "text")) found.push_back(element.data());
    return found;
}

} // namespace scenes
