#include "app/drawing/outlines/drawing_formats.hpp"

#include "app/drawing/outlines/sides.hpp"
#include "app/drawing/trace/border_chains.hpp"
#include "app/drawing/trace/picture.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

// Borders shorter than this times simplify are closed to points. Their ends move by simplify at
// most then, so that the borders that end there stay as straight as they were.
constexpr double kShortest = 2.0;
constexpr double kDirt = 2.0; // times simplify, squared: stones smaller than this are dirt

void check_picture_options(const DrawingFrame& frame, const DrawingOptions& options)
{
    constexpr double kSmallest = 0.05, kLargest = 100.0; // [m]
    const auto fits = [&](double length) { return length >= kSmallest && length <= kLargest; };
    if (!fits(options.width) || !fits(options.height)) {
        refuse(frame, 0,
               "is a picture of " + number(options.width, 4) + " x " +
                   number(options.height, 4) +
                   " m; give the size of what it shows, 0.05 to 100 m each: "
                   "wall.picture_width, wall.picture_height");
    }
    if (!(options.simplify >= 0.0 &&
          options.simplify <= 0.1 * std::min(options.width, options.height))) {
        refuse(frame, 0, "wall.simplify must be in [0, 0.1] of the picture's smaller side");
    }
}

void note_pixels(Drawing& drawing, PixelSize pixel, double simplify)
{
    const double larger = std::max(pixel.width, pixel.height),
                 ratio = larger / std::min(pixel.width, pixel.height);
    if (ratio > 1.05) {
        drawing.notes.push_back("Pixels of this size are " + number(pixel.width * 1e3, 4) +
                                " x " + number(pixel.height * 1e3, 4) +
                                " mm: the picture is stretched, or its size is not as given.");
    }
    if (simplify < larger) {
        drawing.notes.push_back("The tolerance of outlines, " + millimetres(simplify) +
                                ", is smaller than a pixel: outlines have steps.");
    }
}

struct Borders {
    ChainNetwork network;
    SimplifiedChains simplified;
    std::size_t closed = 0;
    std::size_t straightened = 0;
};

/// How far from each junction the middle of the mortar may bend because the mortar branches.
std::vector<double> zones_of(const ChainNetwork& network, const Painted& painted,
                             PixelSize pixel)
{
    std::vector<double> zones;
    for (const Junction& junction : network.junctions)
        zones.push_back(distance_to_stone(painted, pixel, junction.at) +
                        std::max(pixel.width, pixel.height));
    return zones;
}

Borders borders_of(const DrawingFrame& frame, const Labels& labels, const Painted& painted,
                   PixelSize pixel, const DrawingOptions& options)
{
    Borders borders;
    const ChainNetwork traced = trace_borders(frame, labels, options.width, options.height);
    // where nothing is closed or moved, and with a tolerance of 0, nothing can cross
    for (const auto& [shortest, straight] :
         {std::pair{kShortest, true}, {kShortest, false}, {0.0, false}}) {
        borders.network = traced;
        borders.closed =
            close_short_chains(borders.network, labels.stones, shortest * options.simplify);
        borders.straightened =
            straight ? straighten_junctions(borders.network,
                                            zones_of(borders.network, painted, pixel),
                                            options.simplify)
                     : 0;
        borders.simplified = simplify_chains(borders.network, options.simplify);
        if (!borders.simplified.crossing) return borders;
    }
    refuse(frame, 0, "has borders that cross when simplified; make wall.simplify smaller");
}

void note_borders(Drawing& drawing, const Borders& borders, double simplify)
{
    std::size_t before = 0, after = 0;
    for (std::size_t c = 0; c < borders.network.chains.size(); ++c) {
        if (borders.network.chains[c].gone) continue;
        before += borders.network.chains[c].points.size() - 1;
        after += borders.simplified.points[c].size() - 1;
    }
    drawing.notes.push_back("Borders between stones were simplified to " +
                            millimetres(simplify) + ": " + std::to_string(after) +
                            " sides of " + std::to_string(before) + ".");
    if (borders.closed > 0) {
        drawing.notes.push_back(
            counted(borders.closed, "border", "borders") + " shorter than " +
            millimetres(kShortest * simplify) +
            (borders.closed == 1 ? " was closed to a point." : " were closed to points."));
    }
    if (borders.straightened > 0) {
        drawing.notes.push_back(counted(borders.straightened, "corner", "corners") +
                                " of three stones or more " +
                                (borders.straightened == 1 ? "was" : "were") +
                                " put onto the straight line of two borders.");
    }
    if (borders.simplified.finer > 0) {
        drawing.notes.push_back(
            counted(borders.simplified.finer, "border was", "borders were") +
            " simplified less, to keep clear of others.");
    }
}

} // namespace

Drawing read_picture(const DrawingFrame& frame, std::string_view bytes,
                     const DrawingOptions& options)
{
    check_picture_options(frame, options);
    Drawing drawing;
    Labels labels;
    PixelSize pixel;
    {
        const Picture picture = read_png(frame, bytes);
        pixel = {options.width / picture.columns, options.height / picture.rows};
        const double dirt = kDirt * options.simplify;
        labels = find_stones(frame, picture, pixel, dirt * dirt, drawing.notes);
    }
    const Painted painted = painted_stones(labels);
    labels = grow_stones(std::move(labels), pixel);
    note_pixels(drawing, pixel, options.simplify);
    try {
        const Borders borders = borders_of(frame, labels, painted, pixel, options);
        note_borders(drawing, borders, options.simplify);
        std::vector<std::vector<dem::Point>> outlines =
            outlines_of(frame, borders.network, borders.simplified, labels.stones);
        for (std::size_t s = 0; s < outlines.size(); ++s)
            if (!labels.is_opening[s]) drawing.blocks.push_back({std::move(outlines[s]), ""});
    } catch (const TooCrowded& crowd) {
        refuse(frame, 0,
               "has too many borders near " + raw_coordinates(frame, crowd.at) +
                   " m; make the picture smaller");
    }
    return drawing;
}

} // namespace app
