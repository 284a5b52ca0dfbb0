#pragma once
/// A moving picture of one push, for pages that take a picture and no script: the wall, and its
/// capacity curve with a dot.

#include "app/output/wall_body.hpp"
#include "dem/scene/snapshot.hpp"

#include <span>
#include <string>
#include <vector>

namespace app {

/// Frames of a film. Between two of them motion is straight.
constexpr int kFilmPictures = 40, kFewestPictures = 12;
constexpr std::size_t kFilmStills = 80; ///< at most, of a film of pictures

struct FilmText {
    std::string title = {};
    double load_height = 1.10; ///< of the horizontal load, for the drift [m], > 0
    StoneTints tints = {};
};

/// Animated SVG (SMIL), without script: it plays for ever, and programs that play nothing show
/// its last frame. Larger walls have fewer frames, so that the file stays below 0.4 MB up to
/// some 700 blocks.
/// @param frames of one wall, evenly along its push, two or more
/// @param displacement, force of the whole push [m] [N], as many
/// @throws std::invalid_argument for fewer frames, and as wall_picture() does
[[nodiscard]] std::string film_svg(std::span<const dem::Snapshot> frames,
                                   std::span<const double> displacement,
                                   std::span<const double> force, const FilmText& text);

/// The same film as pictures that stand still, for programs that make a film of them.
/// @throws as film_svg()
[[nodiscard]] std::vector<std::string> film_stills(std::span<const dem::Snapshot> frames,
                                                   std::span<const double> displacement,
                                                   std::span<const double> force,
                                                   const FilmText& text);

} // namespace app
