#pragma once
/// Single stones, from a map of what is stone.

#include "app/photograph/mortar_maps.hpp"

namespace app {

/// Stones are numbered from 1; 0 is mortar.
struct Stones {
    cv::Mat label; ///< CV_32S
    int count = 0;
};

/// Whole stones without holes and hairs; the narrow and the very small are dirt.
[[nodiscard]] Stones clean(const Stones& stones);

/// Each pixel of a mask goes to the nearest stone.
[[nodiscard]] Stones grown(const Stones& stones, const cv::Mat& within);

/// The pieces of a map, divided where they are narrow and along lines of mortar, without dirt.
[[nodiscard]] Stones divided(const Stoneness& map);

/// The same stones on a larger picture, each border where the colour is halfway between that of
/// its stone and that of the mortar. Stones that were divided where no mortar is are one again.
/// @param lab of the larger picture
[[nodiscard]] Stones at_half_way(const cv::Mat& lab, const Stones& stones);

/// By how many times colours change more at the borders of stones than elsewhere.
[[nodiscard]] double sharpness_of(const cv::Mat& lab, const Stones& stones);

/// How much pieces look like the stones of a wall.
struct Shape {
    double solidity = 0.0; ///< area over that of the convex hull, mean by area [-]
    double cover = 0.0;    ///< share of the picture that is stone [-]
    double largest = 1.0;  ///< share of the largest piece in that [-]
};

/// @param map holes in it count as no stone
[[nodiscard]] Shape shape_of(const Stones& stones, const Stoneness& map);

} // namespace app
