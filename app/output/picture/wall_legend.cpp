#include "app/output/picture/wall_legend.hpp"

#include "app/output/picture/wall_body.hpp"
#include "app/text/number_text.hpp"

#include <array>
#include <cmath>

namespace app {

namespace {

constexpr double kSwatch = 34.0; // width of a sample [px]

/// Two significant digits, never as a power of ten.
std::string rounded(double value)
{
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
    return number(std::round(value / step) * step, 9);
}

std::string in_millimetres(double metres) { return rounded(metres * 1e3); }

/// A line that grows from `thin` to `thick` over the width of a sample.
std::string taper(Pixel at, double thin, double thick, std::string_view colour,
                  std::string_view edge = "none")
{
    const std::array<Pixel, 4> shape = {
        Pixel{at.x, at.y - thin / 2}, Pixel{at.x + kSwatch, at.y - thick / 2},
        Pixel{at.x + kSwatch, at.y + thick / 2}, Pixel{at.x, at.y + thin / 2}};
    return svg_polygon(shape, svg_attribute("fill", colour) + svg_attribute("stroke", edge));
}

std::string slip_text(const MarkSizes& sizes)
{
    const std::string from = in_millimetres(sizes.threshold);
    return sizes.widest_slip > 0.0 ? from + " to " + in_millimetres(sizes.widest_slip) + " mm"
                                   : "> " + from + " mm: none";
}

std::string thrust_text(double widest_force)
{
    return widest_force > 0.0 ? "up to " + rounded(widest_force * 1e-3) + " kN per face"
                              : "none";
}

} // namespace

double wall_legend_height(const MarkSizes& sizes, const StoneTints& tints)
{
    return sizes.crushed || !tints.name.empty() ? 82.0 : 56.0;
}

std::string draw_wall_legend(Pixel top_left, double width, const MarkSizes& sizes,
                             double widest_force, double mark_size, const StoneTints& tints)
{
    const std::string above = "> " + in_millimetres(sizes.threshold) + " mm";
    const auto at = [&](int column, int row) -> Pixel {
        return {top_left.x + column * width / 3.0, top_left.y + 14.0 + row * 26.0};
    };
    const auto end = [](Pixel p) -> Pixel { return {p.x + kSwatch, p.y}; };
    const auto label = [](Pixel p, std::string_view text) {
        return svg_text({p.x + kSwatch + 10.0, p.y + 4.5}, text, "");
    };

    std::string drawn =
        svg_line({top_left.x, top_left.y - 6.0}, {top_left.x + width, top_left.y - 6.0},
                 svg_stroke("#ccc", 1.0));
    Pixel p = at(0, 0);
    drawn +=
        svg_line(p, end(p), svg_stroke(kCrackColour, 3.0)) + label(p, "unit cracked through");
    p = at(0, 1);
    drawn += svg_line(p, end(p), svg_stroke(kCrackColour, 1.6) + "stroke-dasharray=\"4 2.5\"") +
             label(p, "unit partly damaged");
    p = at(1, 0);
    drawn += taper(p, 1.0, 9.0, kGapColour, kOpeningColour) +
             label(p, "joint open " + above + " (drawn to scale)");
    p = at(1, 1);
    drawn += taper(p, kSlipThinnest * mark_size, kSlipWidest * mark_size, kSlipColour) +
             half_arrows({p.x + kSwatch / 2, p.y}, {1, 0}, {0, -1}, mark_size) +
             label(p, "closed joint slid " + slip_text(sizes));
    p = at(2, 0);
    drawn +=
        svg_group("opacity=\"0.6\"", taper(p, 0.5, kThrustWidest * mark_size, kThrustColour)) +
        label(p, "compression " + thrust_text(widest_force));
    p = at(0, 2);
    if (sizes.crushed)
        drawn += svg_group(svg_attribute("fill", kCrushColour),
                           crushed_mark({p.x + 8, p.y}, 0.0, 1.5) +
                               crushed_mark({p.x + 26, p.y}, 1.0, 1.5)) +
                 label(p, "crushing; full: crushed through");
    p = at(1, 2);
    if (!tints.name.empty())
        drawn += svg_rectangle({p.x + 4, p.y - 7}, kSwatch - 8, 14,
                               svg_attribute("fill", kKindTints[1]) + "stroke=\"#a3937a\"") +
                 label(p, tints.name);
    p = at(2, 1);
    return drawn + svg_rectangle({p.x + 4, p.y - 7}, kSwatch - 8, 14, svg_stroke("#bbb", 0.9)) +
           label(p, "undeformed");
}

} // namespace app
