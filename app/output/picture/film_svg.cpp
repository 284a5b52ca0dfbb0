#include "app/output/picture/film_svg.hpp"

#include "app/output/picture/chart_frame.hpp"
#include "app/output/picture/film_shapes.hpp"
#include "app/output/picture/svg_elements.hpp"
#include "app/output/picture/wall_view.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/mechanism/snapshot_reading.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace app {
namespace {

constexpr double kWide = 960.0, kWallWide = 480.0, kHigh = 470.0, kTop = 64.0; // [px]
constexpr double kRoomLeft = 78.0, kRoomRight = 14.0, kRoomBelow = 28.0; // around the wall
constexpr double kSeconds = 8.0;
constexpr int kMostShapes = 5'600; // frames times moving shapes: 0.4 MB

/// How the wall moves, with its curve.
struct Scenario {
    MovingWall film;
    Chart chart;                       ///< its first series is the curve
    std::vector<Pixel> dots;           ///< on the curve, one for each frame [of the axes]
    std::vector<std::string> captions; ///< as many
    bool pushed = true;                ///< an arrow pushes it
};

std::string moved_text(const dem::Snapshot& wall, double load_height)
{
    return fixed(wall.displacement * 1e3, 1) + " mm,  drift " +
           fixed(fragility::percent_drift(wall.displacement, load_height), 2) + " %";
}

/// Texts of which one is seen at a time.
std::string moving_captions(const MovingWall& film, const std::vector<std::string>& texts,
                            Pixel at)
{
    std::string drawn;
    for (std::size_t i = 0; i < film.frames.size(); ++i) {
        const bool last = i + 1 == film.frames.size();
        const std::size_t all = film.frames.size() + film.frames.size() / kFilmHold - 1;
        const auto time = [&](std::size_t k) {
            return number(static_cast<double>(k) / static_cast<double>(all), 4);
        };
        // seen from its own time to that of the next
        const std::string before = i > 0 ? "hidden;" : "", from = i > 0 ? "0;" : "",
                          after = last ? "" : ";hidden", to = last ? "" : ";" + time(i + 1);
        drawn += "<text x=\"" + svg_number(at.x) + "\" y=\"" + svg_number(at.y) +
                 "\" visibility=\"" + (last ? "visible" : "hidden") + "\">" +
                 xml_escape(texts[i]) +
                 "<animate attributeName=\"visibility\" calcMode=\"discrete\" values=\"" +
                 before + "visible" + after + "\" keyTimes=\"" + from + time(i) + to + "\" " +
                 film.clock + "/></text>\n";
    }
    return svg_group("font-size=\"15\"", drawn);
}

/// The arrow of the horizontal load goes with the beam, or with the whole wall where there is
/// none.
std::string moving_arrow(const MovingWall& film, double load_height)
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
           svg_motion(film, "transform", values) + "<path d=\"M" + x(52) + " 0H" + x(12) +
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
    chart.top = TopAxis{"Drift [%]", fragility::percent_per_metre(load_height * 1e3)};
    Series curve{.colour = "#0072B2", .width = 2.0};
    for (std::size_t i = 0; i < displacement.size(); ++i) {
        curve.x.push_back(displacement[i] * 1e3);
        curve.y.push_back(force[i] * 1e-3);
    }
    chart.series.push_back(std::move(curve));
    return chart;
}

std::string moving_dot(const Scenario& s, const ChartFrame& frame)
{
    std::vector<std::string> x, y;
    for (const Pixel dot : s.dots) {
        const Pixel p = frame.place(dot.x, dot.y);
        x.push_back(svg_number(p.x));
        y.push_back(svg_number(p.y));
    }
    return "<circle r=\"6\" cx=\"" + x.back() + "\" cy=\"" + y.back() +
           "\" fill=\"#d55e00\" stroke=\"white\" stroke-width=\"2\">" +
           svg_motion(s.film, "cx", x) + svg_motion(s.film, "cy", y) + "</circle>\n";
}

std::string moving_curve(const Scenario& scenario)
{
    const Chart& chart = scenario.chart;
    const ChartFrame frame = lay_out_chart(chart);
    std::vector<Pixel> points;
    const Series& s = chart.series.front();
    for (std::size_t i = 0; i < s.x.size(); ++i)
        if (frame.shows(s.x[i], s.y[i])) points.push_back(frame.place(s.x[i], s.y[i]));
    return svg_group("transform=\"translate(" + svg_number(kWallWide) + ' ' + svg_number(kTop) +
                         ")\"",
                     draw_frame(chart, frame) +
                         svg_polyline(points, line_attributes(s, frame.colours.front())) +
                         moving_dot(scenario, frame));
}

/// At most as many as asked for, with the first and the last.
std::vector<const dem::Snapshot*> chosen(std::span<const dem::Snapshot> frames,
                                         std::size_t most)
{
    const std::size_t steps = std::min(frames.size(), most) - 1;
    std::vector<const dem::Snapshot*> some;
    for (std::size_t i = 0; i <= steps; ++i)
        some.push_back(&frames[i * (frames.size() - 1) / steps]);
    return some;
}

/// The factor at which the frame that is farthest out is still a wall, and the place of all
/// frames.
WallView film_view(const std::vector<const dem::Snapshot*>& frames)
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

/// One film, or one picture of it: seen by what plays nothing, the last of film.frames.
std::string film_page(const Scenario& scenario, const FilmText& text)
{
    const MovingWall& film = scenario.film;
    const WallBox rest = box_of(film.frames.front()->blocks, 0.0);
    const Pixel left = film.view.place({rest.low.x, rest.low.z}),
                right = film.view.place({rest.high.x, rest.low.z});
    const std::string wall = moving_wall(film, text.tints);
    const std::string body =
        svg_text({24.0, 30.0}, text.title, "font-size=\"18\" font-weight=\"bold\"") +
        moving_captions(film, scenario.captions, {24.0, 54.0}) +
        svg_text({kWide - 24.0, 30.0}, "displacements drawn × " + number(film.view.scale, 6),
                 "fill=\"#666\" text-anchor=\"end\"") +
        svg_window({0.0, kTop}, kWallWide, kHigh - kTop,
                   wall +
                       svg_line({left.x - 16.0, left.y}, {right.x + 16.0, right.y},
                                svg_stroke("#444", 2.0)) +
                       (scenario.pushed ? moving_arrow(film, text.load_height) : "")) +
        moving_curve(scenario);
    return svg_page(kWide, kHigh, text.title.empty() ? "A wall that moves" : text.title, body);
}

Scenario push_of(MovingWall film, std::span<const double> displacement,
                 std::span<const double> force, const FilmText& text)
{
    Scenario s{std::move(film), curve_chart(displacement, force, text.load_height), {}, {}};
    for (const dem::Snapshot* wall : s.film.frames) {
        s.dots.push_back({wall->displacement * 1e3, wall->force * 1e-3});
        s.captions.push_back(moved_text(*wall, text.load_height) + ",  " +
                             fixed(wall->force * 1e-3, 1) + " kN");
    }
    return s;
}

Chart history_chart(const ShakenFrames& shaken, double load_height)
{
    Chart chart;
    chart.x_label = "Time [s]";
    chart.y_label = "Drift [%]";
    chart.width = kWide - kWallWide;
    chart.height = kHigh - kTop;
    Series curve{.colour = "#0072B2", .width = 1.5};
    for (std::size_t i = 0; i < shaken.time.size(); ++i) {
        curve.x.push_back(shaken.time[i]);
        curve.y.push_back(fragility::percent_drift(shaken.displacement[i], load_height));
    }
    chart.series.push_back(std::move(curve));
    return chart;
}

/// Time from its beginning to its beginning again, with the last frame held.
std::string film_clock(double seconds)
{
    return svg_attribute("dur", number(seconds, 3) + "s") + "repeatCount=\"indefinite\"";
}

void check_film(std::span<const dem::Snapshot> frames, const FilmText& text)
{
    if (frames.size() < 2) throw std::invalid_argument("film: two frames are needed");
    if (!(text.load_height > 0.0))
        throw std::invalid_argument("film: the height of the load must be positive");
}

} // namespace

std::string film_svg(std::span<const dem::Snapshot> frames,
                     std::span<const double> displacement, std::span<const double> force,
                     const FilmText& text)
{
    check_film(frames, text);
    const std::size_t shapes = frames[0].blocks.size() + frames[0].faces.size() / 3;
    const auto most = static_cast<std::size_t>(
        std::clamp(static_cast<int>(kMostShapes / std::max<std::size_t>(shapes, 1)),
                   kFewestPictures, kFilmPictures));
    MovingWall film{chosen(frames, most), {}, {}};
    film.view = film_view(film.frames);
    film.clock = film_clock(kSeconds);
    return film_page(push_of(std::move(film), displacement, force, text), text);
}

std::string shaken_film_svg(const ShakenFrames& shaken, const FilmText& text)
{
    check_film(shaken.frames, text);
    MovingWall film{chosen(shaken.frames, shaken.frames.size()), {}, {}};
    film.view = film_view(film.frames);
    const std::size_t n = shaken.frames.size();
    const double apart =
        (shaken.frame_times.back() - shaken.frame_times.front()) / static_cast<double>(n - 1);
    film.clock = film_clock(apart * static_cast<double>(n - 1 + n / kFilmHold));
    Scenario s{std::move(film), history_chart(shaken, text.load_height), {}, {}, false};
    for (std::size_t i = 0; i < n; ++i) {
        const dem::Snapshot& wall = shaken.frames[i];
        s.dots.push_back({shaken.frame_times[i],
                          fragility::percent_drift(wall.displacement, text.load_height)});
        s.captions.push_back(fixed(shaken.frame_times[i], 2) + " s,  " +
                             moved_text(wall, text.load_height));
    }
    return film_page(s, text);
}

std::vector<std::string> film_stills(std::span<const dem::Snapshot> frames,
                                     std::span<const double> displacement,
                                     std::span<const double> force, const FilmText& text)
{
    check_film(frames, text);
    const MovingWall film{chosen(frames, kFilmStills), {}, {}};
    const WallView view = film_view(film.frames);
    std::vector<std::string> stills;
    for (const dem::Snapshot* const frame : film.frames)
        stills.push_back(film_page(push_of({{film.frames.front(), frame}, view, "dur=\"1s\""},
                                           displacement, force, text),
                                   text));
    return stills;
}

} // namespace app
