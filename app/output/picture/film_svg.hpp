#pragma once
/// A moving picture of one push, or of one shaking, for pages that take a picture and no
/// script: the wall, and its curve with a dot.

#include "app/output/picture/wall_body.hpp"
#include "dem/scene/geometry/snapshot.hpp"

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

/// A wall on ground that moves.
struct ShakenFrames {
    std::span<const dem::Snapshot> frames;      ///< two or more, at equal times
    std::span<const double> frame_times;        ///< [s], as many
    std::span<const double> time, displacement; ///< the whole history [s], of the top [m]
};

/// The film of a wall that is shaken, in real time, with all its frames; beside it the drift
/// over the time with a dot.
/// @throws as film_svg()
[[nodiscard]] std::string shaken_film_svg(const ShakenFrames& shaken, const FilmText& text);

/// A push as pictures that stand still, for programs that make a film of them.
/// @throws as film_svg()
[[nodiscard]] std::vector<std::string> film_stills(std::span<const dem::Snapshot> frames,
                                                   std::span<const double> displacement,
                                                   std::span<const double> force,
                                                   const FilmText& text);

} // namespace app
