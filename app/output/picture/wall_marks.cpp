#include "app/output/picture/wall_marks.hpp"

#include "dem/scene/mechanism/snapshot_reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace app {

namespace {

using dem::ContactState;
using dem::FaceKind;
using dem::FaceState;
using dem::Snapshot;

std::vector<ContactPixels> place_contacts(const Snapshot& wall, const WallView& view,
                                          const FaceState& face)
{
    std::vector<ContactPixels> placed;
    for (const ContactState& c : face.contacts)
        placed.push_back(place_contact(wall, view, face, c));
    return placed;
}

/// The gap along contacts first..last: there on the side of block a, back on the side of block
/// b.
std::string draw_gap(const std::vector<ContactPixels>& at, std::size_t first, std::size_t last)
{
    std::vector<Pixel> outline;
    for (std::size_t i = first; i <= last; ++i) outline.push_back(at[i].a);
    for (std::size_t i = last + 1; i-- > first;) outline.push_back(at[i].b);
    return svg_polygon(outline, "");
}

/// The two sides of a gap; its ends are left open, so that gaps of neighbouring joints join.
std::string draw_gap_sides(const std::vector<ContactPixels>& at, std::size_t first,
                           std::size_t last)
{
    std::vector<Pixel> a, b;
    for (std::size_t i = first; i <= last; ++i) {
        a.push_back(at[i].a);
        b.push_back(at[i].b);
    }
    return svg_polyline(a, "") + svg_polyline(b, "");
}

struct Gaps {
    std::string areas, sides;
};

/// Adds a gap for each run of neighbouring contacts of which one or the other is open.
void add_gaps(Gaps& gaps, const FaceState& face, const std::vector<ContactPixels>& at,
              double threshold)
{
    const auto open = [&](std::size_t i) {
        return i + 1 < at.size() &&
               std::max(face.contacts[i].opening, face.contacts[i + 1].opening) > threshold;
    };
    for (std::size_t first = 0; first + 1 < at.size(); ++first) {
        if (!open(first)) continue;
        std::size_t last = first + 1;
        while (open(last)) ++last;
        gaps.areas += draw_gap(at, first, last);
        gaps.sides += draw_gap_sides(at, first, last);
        first = last;
    }
}

/// Mean slip of the contacts marked as slipping [m]; 0 unless two or more are.
double mean_slip(const FaceState& face, double threshold)
{
    double sum = 0.0;
    int marked = 0;
    for (const ContactState& c : face.contacts)
        if (slides(c, threshold)) {
            sum += std::abs(c.slip);
            ++marked;
        }
    return marked < 2 ? 0.0 : sum / marked;
}

/// Half-arrows at the middle of a face; which side goes where is read off the drawn positions.
std::string arrows_of(const FaceState& face, const std::vector<ContactPixels>& at, double size)
{
    const ContactPixels& p = at[at.size() / 2];
    const Pixel normal{face.normal.x, -face.normal.z}; // pixels count downwards
    Pixel along{-normal.y, normal.x};
    if ((p.b.x - p.a.x) * along.x + (p.b.y - p.a.y) * along.y < 0.0)
        along = {-along.x, -along.y};
    const Pixel middle{(at.front().middle.x + at.back().middle.x) / 2,
                       (at.front().middle.y + at.back().middle.y) / 2};
    return half_arrows(middle, along, normal, size);
}

} // namespace

std::string draw_openings(const Snapshot& wall, const WallView& view, const MarkSizes& sizes)
{
    Gaps gaps;
    for (const FaceState& face : wall.faces)
        if (face.kind != FaceKind::unit_crack)
            add_gaps(gaps, face, place_contacts(wall, view, face), sizes.threshold);
    const std::string fill = svg_attribute("fill", kGapColour) +
                             svg_attribute("stroke", kGapColour) + "stroke-width=\"0.6\"";
    return svg_group(fill, gaps.areas) +
           svg_group(svg_stroke(kOpeningColour, 1.1 * view.mark_size), gaps.sides);
}

std::string half_arrows(Pixel at, Pixel along, Pixel left, double size)
{
    const double length = 11.0 * size, barb = 4.5 * size, away = 6.0 * size; // [px]
    std::string arrows;
    for (const double side : {1.0, -1.0}) {
        const auto point = [&](double forward, double off) -> Pixel {
            return {at.x + side * (forward * along.x + off * left.x),
                    at.y + side * (forward * along.y + off * left.y)};
        };
        const std::array<Pixel, 3> arrow = {point(-length, away), point(length, away),
                                            point(length - 1.4 * barb, away + barb)};
        arrows += svg_polyline(arrow, svg_stroke(kSlipColour, 0.5 + 0.9 * size));
    }
    return arrows;
}

std::string draw_slips(const Snapshot& wall, const WallView& view, const MarkSizes& sizes)
{
    std::string lines, arrows;
    for (const FaceState& face : wall.faces) {
        const double slip =
            face.kind == FaceKind::unit_crack ? 0.0 : mean_slip(face, sizes.threshold);
        if (slip == 0.0) continue;
        const std::vector<ContactPixels> at = place_contacts(wall, view, face);
        const double share = std::min(1.0, slip / sizes.widest_slip);
        const double width =
            view.mark_size * (kSlipThinnest + (kSlipWidest - kSlipThinnest) * share);
        for (std::size_t i = 0; i + 1 < at.size(); ++i)
            if (slides(face.contacts[i], sizes.threshold) &&
                slides(face.contacts[i + 1], sizes.threshold))
                lines +=
                    svg_line(at[i].middle, at[i + 1].middle, svg_stroke(kSlipColour, width));
        if (share > 0.3) arrows += arrows_of(face, at, view.mark_size);
    }
    return lines + arrows;
}

std::string crushed_mark(Pixel at, double lost, double size)
{
    const double side = 6.0 * size; // [px]
    return svg_rectangle({at.x - side / 2, at.y - side / 2}, side, side,
                         svg_stroke(kCrushColour, 1.0) +
                             svg_attribute("fill-opacity", svg_number(0.25 + 0.75 * lost)));
}

std::string draw_crushed(const Snapshot& wall, const WallView& view)
{
    std::string marks;
    for (const FaceState& face : wall.faces)
        for (const ContactState& c : face.contacts)
            if (c.crushed > 0.0)
                marks += crushed_mark(place_contact(wall, view, face, c).middle, c.crushing,
                                      view.mark_size);
    return svg_group(svg_attribute("fill", kCrushColour), marks);
}

std::string draw_cracks(const Snapshot& wall, const WallView& view)
{
    std::string through, partly;
    for (const FaceState& face : wall.faces) {
        if (face.kind != FaceKind::unit_crack || face.contacts.empty()) continue;
        const std::vector<ContactPixels> at = place_contacts(wall, view, face);
        if (is_cracked_through(face)) {
            through += draw_gap(at, 0, at.size() - 1);
            continue;
        }
        for (std::size_t i = 0; i + 1 < at.size(); ++i)
            if (std::max(face.contacts[i].damage, face.contacts[i + 1].damage) > 0.0)
                partly += svg_line(at[i].middle, at[i + 1].middle, "");
    }
    const std::string red = svg_attribute("stroke", kCrackColour);
    return svg_group(svg_attribute("fill", kCrackColour) + red + "stroke-linejoin=\"round\" " +
                         svg_attribute("stroke-width", svg_number(3.0 * view.mark_size)),
                     through) +
           svg_group(red + svg_attribute("stroke-width", svg_number(2.0 * view.mark_size)) +
                         "stroke-dasharray=\"4 2.5\"",
                     partly);
}

} // namespace app
