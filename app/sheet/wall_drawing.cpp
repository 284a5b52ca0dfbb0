#include "app/sheet/wall_drawing.hpp"

#include "app/output/picture/svg_elements.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace app {
namespace {

/// The smallest rectangle around the units [m].
struct Extent {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    double low = left, high = -left;
};

Extent extent_of(std::span<const DrawnBlock> units)
{
    Extent e;
    for (const DrawnBlock& unit : units)
        for (const dem::Point& p : unit.outline) {
            e.left = std::min(e.left, p.x), e.right = std::max(e.right, p.x);
            e.low = std::min(e.low, p.z), e.high = std::max(e.high, p.z);
        }
    return e;
}

std::string metres(double x) { return number(x, 4) + " m"; }

std::string fill_of(const DrawnBlock& unit)
{
    const bool stone = unit.layer.empty() || unit.layer == "wall";
    return svg_attribute("fill", stone ? "#f1e6d2" : "#cfe3ec") +
           svg_attribute("stroke", "#8a7a5c") + svg_attribute("stroke-width", "0.8");
}

} // namespace

std::string wall_drawing(std::span<const DrawnBlock> units, double width, double height)
{
    constexpr double kSide = 64.0, kBelow = 34.0, kAbove = 8.0; // [px]
    const Extent e = extent_of(units);
    const double scale = std::min((width - kSide - 8.0) / (e.right - e.left),
                                  (height - kAbove - kBelow) / (e.high - e.low));
    const Pixel origin{kSide, kAbove + scale * (e.high - e.low)};
    const auto place = [&](const dem::Point& p) {
        return Pixel{origin.x + scale * (p.x - e.left), origin.y - scale * (p.z - e.low)};
    };
    std::string body;
    for (const DrawnBlock& unit : units) {
        std::vector<Pixel> corners;
        for (const dem::Point& p : unit.outline) corners.push_back(place(p));
        body += svg_polygon(corners, fill_of(unit));
    }
    const Pixel left = place({e.left, e.low}), right = place({e.right, e.low});
    const Pixel top = place({e.left, e.high});
    body +=
        svg_line({left.x - 10.0, left.y}, {right.x + 6.0, right.y}, svg_stroke("#444", 2.0));
    const std::string thin = svg_stroke("#444", 0.9);
    body += svg_line({left.x, left.y + 12.0}, {right.x, right.y + 12.0}, thin) +
            svg_line({left.x - 14.0, left.y}, {left.x - 14.0, top.y}, thin);
    for (const Pixel& end : {left, right})
        body += svg_line({end.x, end.y + 8.0}, {end.x, end.y + 16.0}, thin);
    for (const double y : {left.y, top.y})
        body += svg_line({left.x - 18.0, y}, {left.x - 10.0, y}, thin);
    body += svg_text({0.5 * (left.x + right.x), left.y + 28.0}, metres(e.right - e.left),
                     "text-anchor=\"middle\"") +
            svg_text({left.x - 20.0, 0.5 * (left.y + top.y)}, metres(e.high - e.low),
                     "text-anchor=\"end\"");
    return svg_page(std::max(right.x + 8.0, 100.0), left.y + kBelow, "The wall as built", body);
}

} // namespace app
