#pragma once
/// The borders between the stones of a picture, each traced once: chains of points between
/// junctions.

#include "app/drawing/trace/picture.hpp"
#include "dem/scene/geometry/snapshot.hpp"

#include <vector>

namespace app {

/// Where three or more areas meet, the surroundings of the picture being one; and the four
/// corners of the frame.
struct Junction {
    dem::Point at;         ///< [m], from the lower left corner of the picture
    bool on_frame = false; ///< of the picture
};

/// A border between two areas, without another junction inside.
struct Chain {
    int from = 0, to = 0; ///< indices of junctions
    int left = 0,
        right =
            0; ///< stones beside it, walking from `from` to `to`; kMortar outside of the picture
    std::vector<dem::Point> points; ///< with both ends [m]
    bool gone = false;              ///< closed to a point

    [[nodiscard]] bool on_frame() const { return left == kMortar || right == kMortar; }
};

struct ChainNetwork {
    std::vector<Junction> junctions;
    std::vector<Chain> chains;
};

/// @param width, height of the picture [m]
/// @throws ConfigError if a stone lies within another
[[nodiscard]] ChainNetwork trace_borders(const DrawingFrame& frame, const Labels& labels,
                                         double width, double height);

/// Collapses borders shorter than `least`, shortest first, unless a stone would touch itself or
/// keep fewer than three borders. The frame is kept. Returns how many.
/// @param least [m]
std::size_t close_short_chains(ChainNetwork& network, int stones, double least);

/// The points of a line that are kept: those further than `tolerance` from the line through
/// those kept.
/// @param work distances computed so far
/// @throws TooCrowded
[[nodiscard]] std::vector<dem::Point> simplified(const std::vector<dem::Point>& points,
                                                 double tolerance, std::size_t& work);

/// Puts junctions onto the straight line of two of their borders, where these are one line
/// within `tolerance`. Where mortar branches its middle bends towards the branch: what lies
/// within the zone of a junction tells nothing of the line. Junctions on the frame stay.
/// Returns how many moved.
/// @param zones of each junction: its distance from the nearest stone as painted [m]
/// @param tolerance [m]
std::size_t straighten_junctions(ChainNetwork& network, const std::vector<double>& zones,
                                 double tolerance);

/// The part of each chain that is kept: the points further than `tolerance` from the line
/// through those kept (Douglas and Peucker 1973, Cartographica 10, 112-122). Where borders
/// would cross or touch, their tolerance is halved until they do not; with 0 no point but those
/// on straight lines goes.
struct SimplifiedChains {
    std::vector<std::vector<dem::Point>> points; ///< of each chain, with both ends
    std::size_t finer = 0;                       ///< chains with a smaller tolerance
    bool crossing = false;                       ///< some still cross or touch
};
/// @throws TooCrowded
[[nodiscard]] SimplifiedChains simplify_chains(const ChainNetwork& network, double tolerance);

/// The outline of each stone, counter-clockwise.
/// @throws ConfigError if a stone encloses others
[[nodiscard]] std::vector<std::vector<dem::Point>>
outlines_of(const DrawingFrame& frame, const ChainNetwork& network,
            const SimplifiedChains& simplified, int stones);

} // namespace app
