#include "app/output/film_svg.hpp"

#include "app/output/chart_frame.hpp"
#include "app/output/svg_elements.hpp"
#include "app/output/wall_marks.hpp"
#include "app/output/wall_view.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/snapshot_reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace app {
namespace {

constexpr double kWide = 960.0, kWallWide = 480.0, kHigh = 470.0, kTop = 64.0; // [px]
constexpr double kRoomLeft = 78.0, kRoomRight = 14.0, kRoomBelow = 28.0; // around the wall
constexpr double kSeconds = 8.0;
constexpr int kHold = 5;           // a share of 1/kHold of the frames more at the end, at rest
constexpr double kSeen = 1.2;      // smaller openings are not drawn [px]
constexpr double kCracked = 0.5;   // damage from which a crack is drawn [-]
constexpr int kMostShapes = 5'600; // frames times moving shapes: 0.4 MB

using Frames = std::vector<const dem::Snapshot*>;

struct Film {
    Frames frames;
    WallView view;
    std::string clock; ///< attributes that all motions share
};

/// Tenths of pixels: "1234 567", without points.
std::string whole(double pixels) { return std::to_string(std::lround(10.0 * pixels)); }

std::string text_of(std::span<const Pixel> points)
{
    std::string text;
    for (const Pixel p : points)
        text += (text.empty() ? "" : " ") + whole(p.x) + ' ' + whole(p.y);
    return text;
}

/// Values of an attribute over the frames, with the last held; nothing where they are all the same.
std::string motion(const Film& film, std::string_view name,
                   const std::vector<std::string>& values, std::string_view how = {})
{
    if (std::ranges::all_of(values, [&](const std::string& v) { return v == values.front(); }))
        return {};
    const bool turn = name == "transform";
    std::string text = turn ? "<animateTransform type=\"translate\" " : "<animate ";
    text += svg_attribute("attributeName", name) + std::string(how) + "values=\"";
    for (const std::string& v : values) text += v + ';';
    for (std::size_t i = 0; i < values.size() / kHold; ++i) text += values.back() + ';';
    text.pop_back();
    return text + "\" " + film.clock + "/>";
}

/// A polygon or polyline that moves; its own attributes are those of the last frame.
template <class Outline>
std::string moving_shape(const Film& film, const std::string& kind, const std::string& style,
                         Outline outline, const std::string& more = {})
{
    std::vector<std::string> values;
    for (const dem::Snapshot* frame : film.frames) {
        const auto points = outline(*frame);
        values.push_back(text_of(points));
    }
    return "<" + kind + " points=\"" + values.back() + "\" " + style + ">" +
           motion(film, "points", values) + more + "</" + kind + ">\n";
}

std::string blocks_of(const Film& film, const StoneTints& tints)
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
std::vector<Pixel> gap_of(const Film& film, const dem::Snapshot& wall, std::size_t face)
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
std::string gaps_of(const Film& film)
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
std::vector<Pixel> seam_of(const Film& film, const dem::Snapshot& wall, std::size_t face)
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

/// Potential cracks: in the colour of their stone, which hides the border of both halves, and red from where they crack.
std::string cracks_of(const Film& film, const StoneTints& tints)
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
            motion(film, "fill", colours, how) + motion(film, "stroke", colours, how));
    }
    return svg_group("stroke-width=\"18\" fill=\"none\"", seams) +
           svg_group("stroke-width=\"18\"", drawn);
}

/// Texts of which one is seen at a time.
std::string captions(const Film& film, Pixel at, double load_height)
{
    std::string drawn;
    for (std::size_t i = 0; i < film.frames.size(); ++i) {
        const dem::Snapshot& wall = *film.frames[i];
        const std::string text = fixed(wall.displacement * 1e3, 1) + " mm,  drift " +
                                 fixed(100.0 * wall.displacement / load_height, 2) + " %,  " +
                                 fixed(wall.force * 1e-3, 1) + " kN";
        const bool last = i + 1 == film.frames.size();
        const std::size_t all = film.frames.size() + film.frames.size() / kHold - 1;
        const auto time = [&](std::size_t k) {
            return number(static_cast<double>(k) / static_cast<double>(all), 4);
        };
        // seen from its own time to that of the next
        const std::string before = i > 0 ? "hidden;" : "", from = i > 0 ? "0;" : "",
                          after = last ? "" : ";hidden", to = last ? "" : ";" + time(i + 1);
        drawn += "<text x=\"" + svg_number(at.x) + "\" y=\"" + svg_number(at.y) +
                 "\" visibility=\"" + (last ? "visible" : "hidden") + "\">" + xml_escape(text) +
                 "<animate attributeName=\"visibility\" calcMode=\"discrete\" values=\"" +
                 before + "visible" + after + "\" keyTimes=\"" + from + time(i) + to + "\" " +
                 film.clock + "/></text>\n";
    }
    return svg_group("font-size=\"15\"", drawn);
}

/// The arrow of the horizontal load goes with the beam, or with the whole wall where there is none.
std::string moving_arrow(const Film& film, double load_height)
{
    const auto tip = [&](const dem::Snapshot& wall) -> Pixel {
        std::vector<dem::BlockState> beam;
        for (const dem::BlockState& b : wall.blocks)
            if (b.course == 0) beam.push_back(b);
        const WallBox rest = box_of(beam.empty() ? wall.blocks : beam, 0.0);
        const double z = std::clamp(load_height, rest.low.z, rest.high.z);
        return film.view.place({wall.force < 0.0 ? rest.high.x : rest.low.x, z},
                               {wall.displacement, 0.0});
    };
    std::vector<std::string> values;
    for (const dem::Snapshot* wall : film.frames) {
        const Pixel p = tip(*wall);
        values.push_back(svg_number(p.x) + ' ' + svg_number(p.y));
    }
    const double way = film.frames.back()->force < 0.0 ? -1.0 : 1.0;
    const auto x = [&](double behind) { return svg_number(-way * behind); };
    return "<g transform=\"translate(" + values.back() + ")\">" +
           motion(film, "transform", values) + "<path d=\"M" + x(52) + " 0H" + x(12) +
           "\" stroke=\"#222\" stroke-width=\"3\"/><path d=\"M" + x(4) + " 0L" + x(17) +
           " -6L" + x(17) + " 6z\"/></g>\n";
}

Chart curve_chart(std::span<const double> displacement, std::span<const double> force,
                  double load_height)
{
    Chart chart;
    chart.x_label = "Displacement [mm]";
    chart.y_label = "Horizontal force [kN]";
    chart.width = kWide - kWallWide;
    chart.height = kHigh - kTop;
    chart.top = TopAxis{"Drift [%]", 100.0 / (load_height * 1e3)};
    Series curve{.colour = "#0072B2", .width = 2.0};
    for (std::size_t i = 0; i < displacement.size(); ++i) {
        curve.x.push_back(displacement[i] * 1e3);
        curve.y.push_back(force[i] * 1e-3);
    }
    chart.series.push_back(std::move(curve));
    return chart;
}

std::string moving_dot(const Film& film, const ChartFrame& frame)
{
    std::vector<std::string> x, y;
    for (const dem::Snapshot* wall : film.frames) {
        const Pixel p = frame.place(wall->displacement * 1e3, wall->force * 1e-3);
        x.push_back(svg_number(p.x));
        y.push_back(svg_number(p.y));
    }
    return "<circle r=\"6\" cx=\"" + x.back() + "\" cy=\"" + y.back() +
           "\" fill=\"#d55e00\" stroke=\"white\" stroke-width=\"2\">" + motion(film, "cx", x) +
           motion(film, "cy", y) + "</circle>\n";
}

std::string moving_curve(const Film& film, const Chart& chart)
{
    const ChartFrame frame = lay_out_chart(chart);
    std::vector<Pixel> points;
    const Series& s = chart.series.front();
    for (std::size_t i = 0; i < s.x.size(); ++i)
        if (frame.shows(s.x[i], s.y[i])) points.push_back(frame.place(s.x[i], s.y[i]));
    return svg_group("transform=\"translate(" + svg_number(kWallWide) + ' ' + svg_number(kTop) +
                         ")\"",
                     draw_frame(chart, frame) +
                         svg_polyline(points, line_attributes(s, frame.colours.front())) +
                         moving_dot(film, frame));
}

/// At most as many as asked for, with the first and the last.
Frames chosen(std::span<const dem::Snapshot> frames, std::size_t most)
{
    const std::size_t steps = std::min(frames.size(), most) - 1;
    Frames some;
    for (std::size_t i = 0; i <= steps; ++i)
        some.push_back(&frames[i * (frames.size() - 1) / steps]);
    return some;
}

/// The factor at which the frame that is farthest out is still a wall, and the place of all frames.
WallView film_view(const Frames& frames)
{
    WallView view;
    view.scale = drawing_scale(*frames.back());
    for (const dem::Snapshot* wall : frames)
        view.scale = std::min(view.scale, drawing_scale(*wall));
    WallBox box = box_of(frames.front()->blocks, 0.0);
    const double floor = box.low.z;
    const WallBox rest = box;
    for (const dem::Snapshot* wall : frames) box = join(box, box_of(wall->blocks, view.scale));
    // walls that fly apart leave the picture
    const double most = 0.5 * std::max(rest.high.x - rest.low.x, rest.high.z - rest.low.z);
    box = {
        {std::max(box.low.x, rest.low.x - most), floor},
        {std::min(box.high.x, rest.high.x + most), std::min(box.high.z, rest.high.z + most)}};
    view.pixels_per_metre =
        std::min((kWallWide - kRoomLeft - kRoomRight) / (box.high.x - box.low.x),
                 (kHigh - kTop - kRoomBelow - 16.0) / (box.high.z - box.low.z));
    view.origin = {kRoomLeft - box.low.x * view.pixels_per_metre,
                   kHigh - kRoomBelow + floor * view.pixels_per_metre};
    return view;
}

} // namespace

std::string film_svg(std::span<const dem::Snapshot> frames,
                     std::span<const double> displacement, std::span<const double> force,
                     const FilmText& text)
{
    if (frames.size() < 2) throw std::invalid_argument("film: two frames are needed");
    if (!(text.load_height > 0.0))
        throw std::invalid_argument("film: the height of the load must be positive");
    const std::size_t shapes = frames[0].blocks.size() + frames[0].faces.size() / 3;
    const auto most = static_cast<std::size_t>(
        std::clamp(static_cast<int>(kMostShapes / std::max<std::size_t>(shapes, 1)),
                   kFewestPictures, kFilmPictures));
    Film film{chosen(frames, most), {}, {}};
    film.view = film_view(film.frames);
    film.clock = svg_attribute("dur", number(kSeconds, 3) + "s") + "repeatCount=\"indefinite\"";
    const WallBox rest = box_of(frames[0].blocks, 0.0);
    const Pixel left = film.view.place({rest.low.x, rest.low.z}),
                right = film.view.place({rest.high.x, rest.low.z});
    const std::string wall =
        svg_group("transform=\"scale(0.1)\"",
                  gaps_of(film) + blocks_of(film, text.tints) + cracks_of(film, text.tints));
    const std::string body =
        svg_text({24.0, 30.0}, text.title, "font-size=\"18\" font-weight=\"bold\"") +
        captions(film, {24.0, 54.0}, text.load_height) +
        svg_text({kWide - 24.0, 30.0}, "displacements drawn × " + number(film.view.scale, 6),
                 "fill=\"#666\" text-anchor=\"end\"") +
        svg_window({0.0, kTop}, kWallWide, kHigh - kTop,
                   wall +
                       svg_line({left.x - 16.0, left.y}, {right.x + 16.0, right.y},
                                svg_stroke("#444", 2.0)) +
                       moving_arrow(film, text.load_height)) +
        moving_curve(film, curve_chart(displacement, force, text.load_height));
    return svg_page(kWide, kHigh, text.title.empty() ? "A wall that is pushed" : text.title,
                    body);
}

} // namespace app
