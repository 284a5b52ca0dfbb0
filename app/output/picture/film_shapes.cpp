#include "app/output/picture/film_shapes.hpp"

#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_marks.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace app {
namespace {

constexpr double kSeen = 1.2;    // smaller openings are not drawn [px]
constexpr double kCracked = 0.5; // damage from which a crack is drawn [-]

/// Tenths of pixels: "1234 567", without points.
std::string whole(double pixels) { return std::to_string(std::lround(10.0 * pixels)); }

std::string text_of(std::span<const Pixel> points)
{
    std::string text;
    for (const Pixel p : points)
        text += (text.empty() ? "" : " ") + whole(p.x) + ' ' + whole(p.y);
    return text;
}

/// A polygon or polyline that moves; its own attributes are those of the last frame.
template <class Outline>
std::string moving_shape(const MovingWall& film, const std::string& kind,
                         const std::string& style, Outline outline,
                         const std::string& more = {})
{
    std::vector<std::string> values;
    for (const dem::Snapshot* frame : film.frames) {
        const auto points = outline(*frame);
        values.push_back(text_of(points));
    }
    return "<" + kind + " points=\"" + values.back() + "\" " + style + ">" +
           svg_motion(film, "points", values) + more + "</" + kind + ">\n";
}

std::string blocks_of(const MovingWall& film, const StoneTints& tints)
{
    std::string drawn;
    for (std::size_t b = 0; b < film.frames.front()->blocks.size(); ++b) {
        const auto outline = [&](const dem::Snapshot& wall) {
            const dem::BlockState& block = wall.blocks.at(b);
            std::vector<Pixel> points;
            for (std::size_t i = 0; i < block.outline.size(); ++i)
                points.push_back(film.view.place(block.outline[i], block.displacement.at(i)));
            return points;
        };
        // corners alone: contact points along straight sides change nothing that is seen
        const dem::BlockState& rest = film.frames.front()->blocks[b];
        std::vector<std::size_t> corners;
        for (std::size_t i = 0, n = rest.outline.size(); i < n; ++i) {
            const dem::Point p = rest.outline[(i + n - 1) % n], q = rest.outline[i],
                             r = rest.outline[(i + 1) % n];
            const double turn = (q.x - p.x) * (r.z - q.z) - (q.z - p.z) * (r.x - q.x);
            if (std::abs(turn) > 1e-9) corners.push_back(i);
        }
        const auto of_corners = [&](const dem::Snapshot& wall) {
            const std::vector<Pixel> all = outline(wall);
            std::vector<Pixel> points;
            for (const std::size_t i : corners) points.push_back(all[i]);
            return points;
        };
        drawn += moving_shape(film, "polygon", svg_attribute("fill", block_tint(rest, tints)),
                              of_corners);
    }
    return svg_group("stroke=\"#8d7f68\" stroke-width=\"8\" stroke-linejoin=\"round\"", drawn);
}

/// Four corners: the ends of a face on the side of block a, and back on that of block b.
std::vector<Pixel> gap_of(const MovingWall& film, const dem::Snapshot& wall, std::size_t face)
{
    const dem::FaceState& f = wall.faces.at(face);
    const ContactPixels first = place_contact(wall, film.view, f, f.contacts.front()),
                        last = place_contact(wall, film.view, f, f.contacts.back());
    return {first.a, last.a, last.b, first.b};
}

double width_of(const std::vector<Pixel>& gap)
{
    return std::max(std::hypot(gap[0].x - gap[3].x, gap[0].y - gap[3].y),
                    std::hypot(gap[1].x - gap[2].x, gap[1].y - gap[2].y));
}

bool opens(const dem::FaceState& face)
{
    return std::ranges::any_of(face.contacts,
                               [](const dem::ContactState& c) { return c.opening > 1e-4; });
}

/// Joints that come to be seen open. Below the stones: what the stones leave free is the gap.
std::string gaps_of(const MovingWall& film)
{
    std::string drawn;
    const auto& faces = film.frames.front()->faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        if (faces[i].kind == dem::FaceKind::unit_crack || faces[i].contacts.empty()) continue;
        const bool seen = std::ranges::any_of(film.frames, [&](const dem::Snapshot* wall) {
            return opens(wall->faces.at(i)) && width_of(gap_of(film, *wall, i)) > kSeen;
        });
        if (!seen) continue;
        drawn += moving_shape(film, "polygon", "",
                              [&](const dem::Snapshot& wall) { return gap_of(film, wall, i); });
    }
    return svg_group(svg_attribute("fill", kGapColour), drawn);
}

/// Middle line of a face, a little shorter than the face.
std::vector<Pixel> seam_of(const MovingWall& film, const dem::Snapshot& wall, std::size_t face)
{
    const std::vector<Pixel> g = gap_of(film, wall, face);
    const auto between = [&](double t) -> Pixel {
        return {(1 - t) * 0.5 * (g[0].x + g[3].x) + t * 0.5 * (g[1].x + g[2].x),
                (1 - t) * 0.5 * (g[0].y + g[3].y) + t * 0.5 * (g[1].y + g[2].y)};
    };
    return {between(0.02), between(0.98)};
}

double mean_damage_of(const dem::FaceState& face)
{
    double sum = 0.0;
    for (const dem::ContactState& c : face.contacts) sum += c.damage;
    return face.contacts.empty() ? 0.0 : sum / static_cast<double>(face.contacts.size());
}

/// Potential cracks: in the colour of their stone, which hides the border of both halves, and
/// red from where they crack.
std::string cracks_of(const MovingWall& film, const StoneTints& tints)
{
    std::string drawn, seams;
    const auto& faces = film.frames.front()->faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const dem::FaceState& face = faces[i];
        if (face.kind != dem::FaceKind::unit_crack || face.contacts.empty()) continue;
        const std::string stone =
            block_tint(film.frames.front()->blocks.at(face.block_b), tints);
        std::vector<std::string> colours;
        for (const dem::Snapshot* wall : film.frames)
            colours.push_back(mean_damage_of(wall->faces.at(i)) >= kCracked ? kCrackColour
                                                                            : stone);
        const std::string& last = colours.back();
        if (last == stone) {
            seams +=
                moving_shape(film, "polyline", svg_attribute("stroke", stone),
                             [&](const dem::Snapshot& wall) { return seam_of(film, wall, i); });
            continue;
        }
        const std::string style = svg_attribute("fill", last) + svg_attribute("stroke", last);
        const std::string how = "calcMode=\"discrete\" ";
        drawn += moving_shape(
            film, "polygon", style,
            [&](const dem::Snapshot& wall) { return gap_of(film, wall, i); },
            svg_motion(film, "fill", colours, how) + svg_motion(film, "stroke", colours, how));
    }
    return svg_group("stroke-width=\"18\" fill=\"none\"", seams) +
           svg_group("stroke-width=\"18\"", drawn);
}

} // namespace

std::string svg_motion(const MovingWall& film, std::string_view name,
                       const std::vector<std::string>& values, std::string_view how)
{
    if (std::ranges::all_of(values, [&](const std::string& v) { return v == values.front(); }))
        return {};
    const bool turn = name == "transform";
    std::string text = turn ? "<animateTransform type=\"translate\" " : "<animate ";
    text += svg_attribute("attributeName", name) + std::string(how) + "values=\"";
    for (const std::string& v : values) text += v + ';';
    for (std::size_t i = 0; i < values.size() / kFilmHold; ++i) text += values.back() + ';';
    text.pop_back();
    return text + "\" " + film.clock + "/>";
}

std::string moving_wall(const MovingWall& film, const StoneTints& tints)
{
    // corners are in tenths of pixels
    return svg_group("transform=\"scale(0.1)\"",
                     gaps_of(film) + blocks_of(film, tints) + cracks_of(film, tints));
}

} // namespace app
