#pragma once
/// Photographs of walls: where their stones are. Only what is declared here needs OpenCV and
/// libjpeg-turbo. A program that was built without them refuses photographs and names the
/// packages.

#include "app/drawing/trace/picture.hpp"

#include <array>
#include <string_view>

namespace app {

/// How mortar is told from stone. `best` tries the others and takes the one whose stones are
/// the most compact and cover the most.
enum class StoneMethod { best, threshold, kmeans, watershed };
inline constexpr std::array<std::string_view, 4> kStoneMethods = {"best", "threshold", "kmeans",
                                                                  "watershed"};

/// The longest side of a photograph that is looked at [pixels]; larger ones are made smaller,
/// and very small ones larger.
constexpr int kLongestSide = 1600;

struct FoundStones {
    Picture photograph;                     ///< as it was looked at
    Labels labels;                          ///< of its stones and openings
    StoneMethod method = StoneMethod::best; ///< that found them
    double solidity = 0.0; ///< area of a stone over that of its convex hull, mean by area [-]
};

/// The pixels of a JPEG file, turned as its EXIF says.
/// @throws ConfigError if it is none, is damaged, has more than 40 million pixels, or if the
/// program has no library for it
[[nodiscard]] Picture read_jpeg(const DrawingFrame& frame, std::string_view bytes);

/// The stones of a photograph, and its openings: what is painted in the colour of openings. The
/// same photograph gives the same stones in every run of one build.
/// @throws ConfigError if nothing in it looks like a wall, which `best` alone asks, or if the
/// program has no library for it
[[nodiscard]] FoundStones find_photographed(const DrawingFrame& frame, const Picture& picture,
                                            StoneMethod method);

} // namespace app
